// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "core/words/word_row.h"

namespace frana {
namespace {

constexpr auto k_class_words = std::to_array<WordRow>({
    // Hazard schemes: src/analysis/hazard.cpp.
    {"Intensity of one scenario, not a hazard level", "Intensità di uno scenario, non un livello di pericolo",
     "Intensität eines Szenarios, keine Gefahrenstufe", "Intensité d’un scénario, pas un degré de danger",
     "Intensidad de un escenario, no un nivel de peligro"},
    {"{1}, scheme {2}", "{1}, schema {2}", "{1}, Schema {2}", "{1}, schéma {2}", "{1}, esquema {2}"},
    {"Switzerland, debris flows", "Svizzera, colate detritiche", "Schweiz, Murgänge", "Suisse, laves torrentielles",
     "Suiza, flujos de detritos"},
    {"Switzerland, floods", "Svizzera, inondazioni", "Schweiz, Hochwasser", "Suisse, crues", "Suiza, inundaciones"},
    {"Austria, torrents", "Austria, torrenti", "Österreich, Wildbäche", "Autriche, torrents", "Austria, torrentes"},
    {"own limits", "limiti propri", "eigene Grenzwerte", "limites propres", "límites propios"},
    {"Thresholds", "Soglie", "Schwellenwerte", "Seuils", "Umbrales"},
    {"limits of the scene", "limiti della scena", "Grenzwerte der Szene", "limites de la scène",
     "límites de la escena"},
    {"Any class", "Ogni classe", "Jede Klasse", "Toute classe", "Toda clase"},
    {"Low intensity", "Intensità debole", "Schwache Intensität", "Intensité faible", "Intensidad baja"},
    {"Medium intensity", "Intensità media", "Mittlere Intensität", "Intensité moyenne", "Intensidad media"},
    {"High intensity", "Intensità forte", "Starke Intensität", "Intensité forte", "Intensidad alta"},
    {"customary limits, source not read", "limiti d’uso, fonte non letta", "übliche Grenzwerte, Quelle nicht gelesen",
     "limites usuelles, source non lue", "límites habituales, fuente no leída"},
    {"Zones of one scenario, not a hazard zone plan", "Zone di uno scenario, non un piano delle zone di pericolo",
     "Zonen eines Szenarios, kein Gefahrenzonenplan", "Zones d’un scénario, pas un plan des zones de danger",
     "Zonas de un escenario, no un plan de zonas de peligro"},
    {"Yellow zone", "Zona gialla", "Gelbe Zone", "Zone jaune", "Zona amarilla"},
    {"Red zone", "Zona rossa", "Rote Zone", "Zone rouge", "Zona roja"},
    {"depth", "profondità", "Fließtiefe", "hauteur", "profundidad"},
    {"speed", "velocità", "Geschwindigkeit", "vitesse", "velocidad"},
    {"depth × speed", "profondità × velocità", "Fließtiefe × Geschwindigkeit", "hauteur × vitesse",
     "profundidad × velocidad"},
    {"pressure", "pressione", "Druck", "pression", "presión"},
    {"energy head", "altezza energetica", "Energiehöhe", "hauteur d’énergie", "altura de energía"},
    {"deposit", "deposito", "Ablagerung", "dépôt", "depósito"},
    {"and", "e", "und", "et", "y"},
    {"or", "o", "oder", "ou", "o"},

    // Comparison with a survey: src/app/compare/comparison_files.cpp.
    {"Deeper than {1} m counts", "Conta oltre {1} m di profondità", "Es zählt, was tiefer als {1} m ist",
     "Compte ce qui dépasse {1} m de hauteur", "Cuenta lo que supera {1} m de profundidad"},
    {"Observed {1} m²", "Osservato {1} m²", "Beobachtet {1} m²", "Observé {1} m²", "Observado {1} m²"},
    {"Simulated {1} m²", "Simulato {1} m²", "Simuliert {1} m²", "Simulé {1} m²", "Simulado {1} m²"},
    {"Hit {1} m²", "Corretto {1} m²", "Treffer {1} m²", "Concordance {1} m²", "Acierto {1} m²"},
    {"False alarm {1} m²", "Falso allarme {1} m²", "Fehlalarm {1} m²", "Fausse alerte {1} m²", "Falsa alarma {1} m²"},
    {"Miss {1} m²", "Mancato {1} m²", "Verfehlt {1} m²", "Manqué {1} m²", "Omisión {1} m²"},
    {"Outlines {1} m apart", "Distanza fra i perimetri {1} m", "Abstand der Umrisse {1} m",
     "Écart entre les contours {1} m", "Distancia entre los contornos {1} m"},
    {"Hit", "Corretto", "Treffer", "Concordance", "Acierto"},
    {"False alarm", "Falso allarme", "Fehlalarm", "Fausse alerte", "Falsa alarma"},
    {"Miss", "Mancato", "Verfehlt", "Manqué", "Omisión"},
    {"simulated and observed", "simulato e osservato", "simuliert und beobachtet", "simulé et observé",
     "simulado y observado"},
    {"simulated only", "solo simulato", "nur simuliert", "simulé seulement", "solo simulado"},
    {"observed only", "solo osservato", "nur beobachtet", "observé seulement", "solo observado"},
});

}  // namespace

std::span<const WordRow> class_words() {
    return k_class_words;
}

}  // namespace frana
