// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "core/words/word_row.h"

namespace frana {
namespace {

constexpr auto k_attribute_words = std::to_array<WordRow>({
    {"length [m]", "lunghezza [m]", "Länge [m]", "longueur [m]", "longitud [m]"},
    {"mean thickness, vertical [m]", "spessore medio, verticale [m]", "mittlere Mächtigkeit, vertikal [m]",
     "épaisseur moyenne, verticale [m]", "espesor medio, vertical [m]"},
    {"mean thickness, normal to the bed [m]", "spessore medio, normale al letto [m]",
     "mittlere Mächtigkeit, normal zum Bett [m]", "épaisseur moyenne, normale au lit [m]",
     "espesor medio, normal al lecho [m]"},
    {"depth on 99.9 % of the area [m]", "profondità sul 99,9 % dell’area [m]", "Fließtiefe auf 99,9 % der Fläche [m]",
     "hauteur sur 99,9\u202F% de la surface [m]", "profundidad en el 99,9 % del área [m]"},
    {"speed on 99.9 % of the area [m/s]", "velocità sul 99,9 % dell’area [m/s]",
     "Geschwindigkeit auf 99,9 % der Fläche [m/s]", "vitesse sur 99,9\u202F% de la surface [m/s]",
     "velocidad en el 99,9 % del área [m/s]"},
    {"greatest pressure [kPa]", "pressione massima [kPa]", "größter Druck [kPa]", "pression maximale [kPa]",
     "presión máxima [kPa]"},
    {"first arrival [s]", "primo arrivo [s]", "erste Ankunft [s]", "première arrivée [s]", "primera llegada [s]"},
    {"run-out [m]", "distanza di propagazione [m]", "Auslauflänge [m]", "distance de propagation [m]", "alcance [m]"},
    {"drop [m]", "dislivello [m]", "Fallhöhe [m]", "dénivelé [m]", "desnivel [m]"},
    {"angle of reach [°]", "angolo di propagazione [°]", "Pauschalgefälle [°]", "angle de propagation [°]",
     "ángulo de alcance [°]"},
    {"scheme", "schema", "Schema", "schéma", "esquema"},
    {"reference", "fonte", "Quelle", "référence", "referencia"},
    {"exposed feature", "elemento esposto", "exponiertes Objekt", "élément exposé", "elemento expuesto"},
    {"count", "numero", "Anzahl", "nombre", "número"},
    {"reached (1: yes)", "raggiunto (1: sì)", "erreicht (1: ja)", "atteint (1\u202F: oui)", "alcanzado (1: sí)"},
});

}  // namespace

std::span<const WordRow> attribute_words() {
    return k_attribute_words;
}

}  // namespace frana
