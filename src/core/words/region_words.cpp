// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "core/words/word_row.h"

namespace frana {
namespace {

constexpr auto k_region_words = std::to_array<WordRow>({
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
    // Exposed features: src/app/publish/publish_exposure.cpp, src/app/publish/report_exposure.cpp.
    {"Exposed, reached", "Esposti, raggiunti", "Exponiert, erreicht", "Exposés, atteints", "Expuestos, alcanzados"},
    {"Exposed, not reached", "Esposti, non raggiunti", "Exponiert, nicht erreicht", "Exposés, non atteints",
     "Expuestos, no alcanzados"},
    {"Exposed, unknown", "Esposti, sconosciuto", "Exponiert, unbekannt", "Exposés, inconnu", "Expuestos, desconocido"},
    {"{1} of {2} exposed features are reached.", "{1} di {2} elementi esposti sono raggiunti.",
     "{1} von {2} exponierten Objekten werden erreicht.", "{1} des {2} objets exposés sont atteints.",
     "Se alcanzan {1} de {2} elementos expuestos."},
    {"{1} of {2} exposed features are reached by at least one run.",
     "{1} di {2} elementi esposti sono raggiunti in almeno una simulazione.",
     "{1} von {2} exponierten Objekten werden in mindestens einem Lauf erreicht.",
     "{1} des {2} objets exposés sont atteints par au moins un calcul.",
     "Se alcanzan {1} de {2} elementos expuestos en al menos una simulación."},
    {"{1} of {2} exposed features are reached by at least one slope.",
     "{1} di {2} elementi esposti sono raggiunti da almeno un versante.",
     "{1} von {2} exponierten Objekten werden von mindestens einem Hang erreicht.",
     "{1} des {2} objets exposés sont atteints par au moins un versant.",
     "Se alcanzan {1} de {2} elementos expuestos desde al menos una ladera."},
    {"By their count: {1} of {2}.", "Secondo il loro numero: {1} di {2}.", "Nach ihrer Anzahl: {1} von {2}.",
     "Selon leur nombre\u202F: {1} de {2}.", "Según su número: {1} de {2}."},
    {"Of {1} of them the map says nothing: see {2}.", "Di {1} di essi la carta non dice nulla: vedere {2}.",
     "Über {1} von ihnen sagt die Karte nichts: siehe {2}.",
     "De {1} d’entre eux, la carte ne dit rien\u202F: voir {2}.", "De {1} de ellos el mapa no dice nada: véase {2}."},
    {"What is exposed.", "Che cosa è esposto.", "Was exponiert ist.", "Ce qui est exposé.", "Qué está expuesto."},
    {"Exposed features that are reached", "Elementi esposti raggiunti", "Erreichte exponierte Objekte",
     "Objets exposés atteints", "Elementos expuestos alcanzados"},
    {"Feature", "Elemento", "Objekt", "Objet", "Elemento"},
    {"Greatest pressure [kPa]", "Pressione massima [kPa]", "Größter Druck [kPa]", "Pression maximale [kPa]",
     "Presión máxima [kPa]"},
    {"Probability that it is reached [%]", "Probabilità che sia raggiunto [%]",
     "Wahrscheinlichkeit, erreicht zu werden [%]", "Probabilité d’être atteint [%]",
     "Probabilidad de ser alcanzado [%]"},
    {"Slopes that reach it", "Versanti che lo raggiungono", "Hänge, die es erreichen", "Versants qui l’atteignent",
     "Laderas que lo alcanzan"},
    {"The {1} deepest of {2}; {3} has all.", "I {1} più profondi di {2}; {3} li contiene tutti.",
     "Die {1} tiefsten von {2}; {3} enthält alle.", "Les {1} plus profonds des {2}\u202F; {3} les contient tous.",
     "Los {1} más profundos de {2}; {3} los contiene todos."},
    {"{1} has all features, also those that are not reached.",
     "{1} contiene tutti gli elementi, anche quelli non raggiunti.",
     "{1} enthält alle Objekte, auch die nicht erreichten.",
     "{1} contient tous les objets, y compris ceux qui ne sont pas atteints.",
     "{1} contiene todos los elementos, también los no alcanzados."},

    // The table of slopes: src/app/ensemble/region_report.cpp.
    {"Slope", "Versante", "Hang", "Versant", "Ladera"},
    {"Scenario", "Scenario", "Szenario", "Scénario", "Escenario"},
    {"Why it failed", "Perché non è riuscito", "Warum er fehlschlug", "Pourquoi il a échoué", "Por qué falló"},
    {"The first {1} of {2} slopes; {3} has all.", "I primi {1} di {2} versanti; {3} li contiene tutti.",
     "Die ersten {1} von {2} Hängen; {3} enthält alle.",
     "Les {1} premiers des {2} versants\u202F; {3} les contient tous.",
     "Las primeras {1} de {2} laderas; {3} las contiene todas."},

    {"any", "qualsiasi", "jede", "quelconque", "cualquiera"},
});

}  // namespace

std::span<const WordRow> region_words() {
    return k_region_words;
}

}  // namespace frana
