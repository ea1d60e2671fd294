// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "core/words/word_row.h"

namespace frana {
namespace {

constexpr auto k_rows = std::to_array<WordRow>({
    // Maps of regions.
    {"Maximum dynamic pressure of all sources", "Pressione dinamica massima di tutte le sorgenti",
     "Maximaler dynamischer Druck aller Anrissgebiete", "Pression dynamique maximale de toutes les zones de départ",
     "Presión dinámica máxima de todas las áreas de inicio"},
    {"Maximum depth, scenario {1}", "Profondità massima, scenario {1}", "Maximale Fließtiefe, Szenario {1}",
     "Hauteur d’écoulement maximale, scénario {1}", "Profundidad máxima, escenario {1}"},
    {"Maximum velocity, scenario {1}", "Velocità massima, scenario {1}", "Maximale Fließgeschwindigkeit, Szenario {1}",
     "Vitesse maximale, scénario {1}", "Velocidad máxima, escenario {1}"},
    {"Maximum dynamic pressure, scenario {1}", "Pressione dinamica massima, scenario {1}",
     "Maximaler dynamischer Druck, Szenario {1}", "Pression dynamique maximale, scénario {1}",
     "Presión dinámica máxima, escenario {1}"},
    {"Arrival time, scenario {1}", "Tempo di arrivo, scenario {1}", "Ankunftszeit, Szenario {1}",
     "Temps d’arrivée, scénario {1}", "Tiempo de llegada, escenario {1}"},
    {"Sources that arrive, scenario {1}", "Sorgenti che arrivano, scenario {1}",
     "Anrissgebiete, die ankommen, Szenario {1}", "Zones de départ qui arrivent, scénario {1}",
     "Áreas de inicio que llegan, escenario {1}"},
    {"Number of the worst source, scenario {1}", "Numero della sorgente peggiore, scenario {1}",
     "Nummer des schlimmsten Anrissgebiets, Szenario {1}", "Numéro de la pire zone de départ, scénario {1}",
     "Número de la peor área de inicio, escenario {1}"},
    {"Intensity, scenario {1}", "Intensità, scenario {1}", "Intensität, Szenario {1}", "Intensité, scénario {1}",
     "Intensidad, escenario {1}"},

    {"Slopes", "Versanti", "Hänge", "Versants", "Laderas"},
    {"Zones of hazard", "Zone di pericolo", "Gefahrenzonen", "Zones de danger", "Zonas de peligro"},

    // Degrees of hazard: src/analysis/hazard_degree.cpp.
    {"Degree of hazard", "Grado di pericolo", "Gefahrenstufe", "Degré de danger", "Grado de peligro"},
    {"Degree of hazard from intensity and return period", "Grado di pericolo da intensità e tempo di ritorno",
     "Gefahrenstufe aus Intensität und Wiederkehrperiode", "Degré de danger selon l’intensité et le temps de retour",
     "Grado de peligro según intensidad y período de retorno"},
    {"Return periods in years (a)", "Tempi di ritorno in anni (a)", "Wiederkehrperioden in Jahren (a)",
     "Temps de retour en années (a)", "Períodos de retorno en años (a)"},
    {"Limits of intensity", "Limiti di intensità", "Grenzen der Intensität", "Limites d’intensité",
     "Límites de intensidad"},
    {"Matrix", "Matrice", "Matrix", "Matrice", "Matriz"},
    {"Red, high hazard", "Rosso, pericolo elevato", "Rot, erhebliche Gefährdung", "Rouge, danger élevé",
     "Rojo, peligro alto"},
    {"Blue, medium hazard", "Blu, pericolo medio", "Blau, mittlere Gefährdung", "Bleu, danger moyen",
     "Azul, peligro medio"},
    {"Yellow, low hazard", "Giallo, pericolo basso", "Gelb, geringe Gefährdung", "Jaune, danger faible",
     "Amarillo, peligro bajo"},
    {"Yellow-white, residual hazard", "Giallo-bianco, pericolo residuo", "Gelb-weiß, Restgefährdung",
     "Jaune-blanc, danger résiduel", "Amarillo-blanco, peligro residual"},
    {"weak", "debole", "schwach", "faible", "débil"},
    {"medium", "media", "mittel", "moyenne", "media"},
    {"strong", "forte", "stark", "forte", "fuerte"},
    {"any", "qualsiasi", "jede", "quelconque", "cualquiera"},
});

}  // namespace

std::span<const WordRow> region_words() {
    return k_rows;
}

}  // namespace frana
