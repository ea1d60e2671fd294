// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "core/words/word_row.h"

namespace frana {
namespace {

constexpr auto k_accuracy_words = std::to_array<WordRow>({
    {"the result is on cells of {1} m, the scene's own", "il risultato è su celle di {1} m, quelle della scena",
     "das Ergebnis hat Zellen von {1} m, die der Szene", "le résultat est sur des mailles de {1} m, celles de la scène",
     "el resultado es en celdas de {1} m, las de la escena"},
    {"the result is on cells of {1} m", "il risultato è su celle di {1} m", "das Ergebnis hat Zellen von {1} m",
     "le résultat est sur des mailles de {1} m", "el resultado es en celdas de {1} m"},
    {"finer than the DTM's {1} m: between its cells the terrain is interpolated",
     "più piccole di quelle del DTM ({1} m): fra queste il terreno è interpolato",
     "feiner als die des DGM ({1} m): zwischen diesen ist das Gelände interpoliert",
     "plus petites que celles du MNT ({1} m)\u202F: entre celles-ci le terrain est interpolé",
     "menores que las del MDT ({1} m): entre estas el terreno está interpolado"},
    {"all {1} values", "tutti i {1} valori", "alle {1} Werte", "les {1} valeurs", "los {1} valores"},
    {"all {1} values that are not zero on all levels; {2} are, without an estimate",
     "tutti i {1} valori che non sono zero su tutti i livelli; {2} lo sono, senza stima",
     "alle {1} Werte, die nicht auf allen Stufen null sind; {2} sind es, ohne Schätzung",
     "les {1} valeurs qui ne sont pas nulles à tous les niveaux\u202F; {2} le sont, sans estimation",
     "los {1} valores que no son cero en todos los niveles; {2} lo son, sin estimación"},
    {"Discretisation only: errors of data, material and model are not included",
     "Solo discretizzazione: gli errori di dati, materiale e modello non sono inclusi",
     "Nur Diskretisierung: Fehler von Daten, Material und Modell sind nicht enthalten",
     "Discrétisation seule\u202F: les erreurs de données, de matériau et de modèle ne sont pas comprises",
     "Solo discretización: no se incluyen los errores de datos, material y modelo"},
    {"{1} is not claimed: there are too few coarser levels for an estimate of error; {2}",
     "{1} non è garantito: i livelli più grossolani sono troppo pochi per una stima dell’errore; {2}",
     "{1} wird nicht zugesichert: es gibt zu wenige gröbere Stufen für eine Fehlerschätzung; {2}",
     "{1} n’est pas garanti\u202F: il y a trop peu de niveaux plus grossiers pour une estimation de l’erreur\u202F; "
     "{2}",
     "{1} no se garantiza: hay demasiado pocos niveles más gruesos para una estimación del error; {2}"},
    {"{1} is met according to the estimate for {2}; {3}", "{1} è rispettato secondo la stima per {2}; {3}",
     "{1} ist laut Schätzung eingehalten für {2}; {3}", "{1} est respecté selon l’estimation pour {2}\u202F; {3}",
     "{1} se cumple según la estimación para {2}; {3}"},
    {"and {1} more", "e altri {1}", "und {1} weitere", "et {1} de plus", "y {1} más"},
    {"{1} is not claimed for {2} of {3} values, whose estimated error is greater: {4}; {5}",
     "{1} non è garantito per {2} valori su {3}, il cui errore stimato è maggiore: {4}; {5}",
     "{1} wird für {2} von {3} Werten nicht zugesichert, deren geschätzter Fehler größer ist: {4}; {5}",
     "{1} n’est pas garanti pour {2} valeurs sur {3}, dont l’erreur estimée est plus grande\u202F: {4}\u202F; {5}",
     "{1} no se garantiza para {2} de {3} valores, cuyo error estimado es mayor: {4}; {5}"},
    {"The scene's own cells of {1} m were not computed: the estimate does not expect them to reach it. Run without "
     "numerics.accuracy for them, or ask for less",
     "Le celle della scena, di {1} m, non sono state calcolate: secondo la stima non basterebbero. Calcolarle senza "
     "numerics.accuracy, o chiedere di meno",
     "Die Zellen der Szene von {1} m wurden nicht gerechnet: laut Schätzung reichen sie nicht aus. Ohne "
     "numerics.accuracy rechnen oder weniger verlangen",
     "Les mailles de la scène, de {1} m, n’ont pas été calculées\u202F: selon l’estimation elles n’y suffiraient pas. "
     "Les calculer sans numerics.accuracy, ou demander moins",
     "Las celdas de la escena, de {1} m, no se calcularon: según la estimación no bastarían. Calcúlelas sin "
     "numerics.accuracy, o pida menos"},
    {"converging", "convergente", "konvergierend", "convergent", "convergente"},
    {"oscillating", "oscillante", "schwankend", "oscillant", "oscilante"},
    {"diverging", "divergente", "divergierend", "divergent", "divergente"},
    {"settled", "stabile", "gleichbleibend", "stabilisé", "estable"},
    {"limited by the terrain's detail", "limitato dal dettaglio del terreno",
     "durch die Feinheit des Geländes begrenzt", "limité par le détail du terrain",
     "limitado por el detalle del terreno"},
    {"too few levels to tell", "troppo pochi livelli per dirlo", "zu wenige Stufen für eine Aussage",
     "trop peu de niveaux pour conclure", "muy pocos niveles para decirlo"},
});

}  // namespace

std::span<const WordRow> accuracy_words() {
    return k_accuracy_words;
}

}  // namespace frana
