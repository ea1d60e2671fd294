// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "core/words/word_row.h"

namespace frana {
namespace {

constexpr auto k_study_report_words = std::to_array<WordRow>({
    // Titles and headings.
    {"{1}: a range of runs", "{1}: una serie di simulazioni", "{1}: viele Läufe", "{1}\u202F: une série de calculs",
     "{1}: una serie de simulaciones"},
    {"{1}: each source alone", "{1}: ogni sorgente da sola", "{1}: jedes Anrissgebiet für sich",
     "{1}\u202F: chaque zone de départ seule", "{1}: cada área de inicio por sí sola"},
    {"{1}: a region of many slopes", "{1}: una regione di molti versanti", "{1}: eine Region mit vielen Hängen",
     "{1}\u202F: une région de nombreux versants", "{1}: una región de muchas laderas"},
    {"Computed with {1}, study {2}, {3}", "Calcolato con {1}, studio {2}, {3}", "Berechnet mit {1}, Studie {2}, {3}",
     "Calculé avec {1}, étude {2}, {3}", "Calculado con {1}, estudio {2}, {3}"},
    {"Map", "Mappa", "Karte", "Carte", "Mapa"},
    {"Chart", "Diagramma", "Diagramm", "Diagramme", "Diagrama"},
    {"Charts", "Diagrammi", "Diagramme", "Diagrammes", "Diagramas"},
    {"There are no maps.", "Non ci sono mappe.", "Es gibt keine Karten.", "Il n’y a pas de cartes.", "No hay mapas."},
    {"Distributions and inputs", "Distribuzioni e dati di ingresso", "Verteilungen und Eingaben",
     "Distributions et entrées", "Distribuciones y entradas"},
    {"Sensitivity", "Sensibilità", "Sensitivität", "Sensibilité", "Sensibilidad"},
    {"Levels", "Livelli", "Stufen", "Niveaux", "Niveles"},
    {"Median member", "Simulazione mediana", "Mittlerer Lauf", "Calcul médian", "Simulación mediana"},
    {"Failed members", "Simulazioni fallite", "Gescheiterte Läufe", "Calculs en échec", "Simulaciones fallidas"},
    // The answer: src/app/ensemble/study_answer.cpp.
    {"volume", "volume", "Volumen", "volume", "volumen"},
    {"{1} m³ in every run.", "{1} m³ in ogni simulazione.", "{1} m³ in jedem Lauf.", "{1} m³ dans chaque calcul.",
     "{1} m³ en cada simulación."},
    {"{1} m³ in the median of the runs, between {2} and {3} m³ in 90 % of them.",
     "{1} m³ nella mediana delle simulazioni, fra {2} e {3} m³ nel 90 % di esse.",
     "{1} m³ im Median der Läufe, zwischen {2} und {3} m³ in 90 % von ihnen.",
     "{1} m³ dans la médiane des calculs, entre {2} et {3} m³ dans 90\u202F% d’entre eux.",
     "{1} m³ en la mediana de las simulaciones, entre {2} y {3} m³ en el 90 % de ellas."},
    {"What varies.", "Che cosa varia.", "Was variiert.", "Ce qui varie.", "Qué varía."},
    {"{1}. All other values are those of the scene {2}.", "{1}. Tutti gli altri valori sono quelli della scena {2}.",
     "{1}. Alle anderen Werte sind die der Szene {2}.", "{1}. Toutes les autres valeurs sont celles de la scène {2}.",
     "{1}. Todos los demás valores son los de la escena {2}."},
    {"In at least half of the runs the material comes more than {1} m far in map view, in at most 5 % of them less "
     "than "
     "{2} m and in at least 5 % more than {3} m.",
     "In almeno metà delle simulazioni il materiale percorre più di {1} m in pianta, al massimo nel 5 % di esse meno "
     "di {2} m e in almeno il 5 % più di {3} m.",
     "In mindestens der Hälfte der Läufe kommt das Material im Grundriss weiter als {1} m, in höchstens 5 % von ihnen "
     "weniger als {2} m und in mindestens 5 % mehr als {3} m.",
     "Dans au moins la moitié des calculs le matériau parcourt plus de {1} m en plan, dans au plus 5\u202F% d’entre "
     "eux "
     "moins de {2} m et dans au moins 5\u202F% plus de {3} m.",
     "En al menos la mitad de las simulaciones el material recorre más de {1} m en planta, como máximo en el 5 % de "
     "ellas menos de {2} m y al menos en el 5 % más de {3} m."},
    {"In half of the runs the material comes more than {1} m far in map view, in 5 % of them less than {2} m and in 5 "
     "% more than {3} m.",
     "In metà delle simulazioni il materiale percorre più di {1} m in pianta, nel 5 % di esse meno di {2} m e nel 5 % "
     "più di {3} m.",
     "In der Hälfte der Läufe kommt das Material im Grundriss weiter als {1} m, in 5 % von ihnen weniger als {2} m und "
     "in 5 % mehr als {3} m.",
     "Dans la moitié des calculs le matériau parcourt plus de {1} m en plan, dans 5\u202F% d’entre eux moins de {2} m "
     "et dans 5\u202F% plus de {3} m.",
     "En la mitad de las simulaciones el material recorre más de {1} m en planta, en el 5 % de ellas menos de {2} m y "
     "en el 5 % más de {3} m."},
    {"Deeper than {1} m at some time are {2} m² with a probability of at least 95 %, {3} m² with at least 50 %, {4} m² "
     "with at least 5 %.",
     "Coperti per più di {1} m in qualche momento sono {2} m² con una probabilità di almeno il 95 %, {3} m² con almeno "
     "il 50 %, {4} m² con almeno il 5 %.",
     "Irgendwann tiefer als {1} m bedeckt sind {2} m² mit einer Wahrscheinlichkeit von mindestens 95 %, {3} m² mit "
     "mindestens 50 %, {4} m² mit mindestens 5 %.",
     "Couverts de plus de {1} m à un moment sont {2} m² avec une probabilité d’au moins 95\u202F%, {3} m² avec au "
     "moins 50\u202F%, {4} m² avec au moins 5\u202F%.",
     "Cubiertos por más de {1} m en algún momento quedan {2} m² con una probabilidad de al menos el 95 %, {3} m² con "
     "al menos el 50 %, {4} m² con al menos el 5 %."},
    {"The farthest run-out is {1} m in map view, from source {2}; half of the sources come more than {3} m far.",
     "La distanza di propagazione massima è {1} m in pianta, dalla sorgente {2}; metà delle sorgenti supera {3} m.",
     "Die größte Auslauflänge ist {1} m im Grundriss, von Anrissgebiet {2}; die Hälfte der Anrissgebiete kommt weiter "
     "als {3} m.",
     "La plus grande distance de propagation est de {1} m en plan, depuis la zone de départ {2}\u202F; la moitié des "
     "zones "
     "dépasse {3} m.",
     "El mayor alcance es de {1} m en planta, desde el área de inicio {2}; la mitad de las áreas supera {3} m."},
    {"At least one source covers {1} m² deeper than {2} m.", "Almeno una sorgente copre {1} m² per più di {2} m.",
     "Mindestens ein Anrissgebiet bedeckt {1} m² tiefer als {2} m.",
     "Au moins une zone de départ couvre {1} m² de plus de {2} m.",
     "Al menos un área de inicio cubre {1} m² con más de {2} m."},
    {"Maps show the worst of all: what at least one of the sources causes, not all of them together.",
     "Le mappe mostrano il peggio di tutte: ciò che causa almeno una delle sorgenti, non tutte insieme.",
     "Karten zeigen das Schlimmste von allen: was mindestens eines der Anrissgebiete verursacht, nicht alle zusammen.",
     "Les cartes montrent le pire de toutes\u202F: ce que cause au moins une des zones de départ, non toutes ensemble.",
     "Los mapas muestran lo peor de todas: lo que causa al menos una de las áreas de inicio, no todas juntas."},
    {"{1} of {2} sources were computed, each failing alone.",
     "{1} sorgenti su {2} sono state calcolate, ciascuna da sola.",
     "{1} von {2} Anrissgebieten wurden berechnet, jedes für sich.",
     "{1} zones de départ sur {2} ont été calculées, chacune seule.",
     "Se calcularon {1} de {2} áreas de inicio, cada una por sí sola."},
    {"{1} of {2} runs were computed; their values are drawn from the distributions (sampling {3}, seed {4}).",
     "{1} simulazioni su {2} sono state calcolate; i loro valori sono estratti dalle distribuzioni (campionamento {3}, seme "
     "{4}).",
     "{1} von {2} Läufen sind gerechnet; ihre Werte sind aus den Verteilungen gezogen (Stichprobe {3}, Startwert {4}).",
     "{1} calculs sur {2} ont été effectués\u202F; leurs valeurs sont tirées des distributions (échantillonnage {3}, "
     "graine {4}).",
     "{1} de {2} simulaciones se calcularon; sus valores se extraen de las distribuciones (muestreo {3}, semilla {4})."},
    {"{1} failed and are in no map.", "{1} sono fallite e non sono in alcuna mappa.",
     "{1} scheiterten und sind in keiner Karte.", "{1} ont échoué et ne sont dans aucune carte.",
     "{1} fallaron y no están en ningún mapa."},
    {"The standard error of the probabilities is at most {1} %, on average {2} % where it is not 0: it measures the "
     "number of runs, not how well model, terrain and distributions describe nature.",
     "L’errore standard delle probabilità è al massimo {1} %, in media {2} % dove non è 0: misura il numero di "
     "simulazioni, non quanto bene modello, terreno e distribuzioni descrivono la natura.",
     "Der Standardfehler der Wahrscheinlichkeiten ist höchstens {1} %, im Mittel {2} %, wo er nicht 0 ist: er misst "
     "die Zahl der Läufe, nicht, wie gut Modell, Gelände und Verteilungen die Natur beschreiben.",
     "L’erreur type des probabilités est d’au plus {1}\u202F%, en moyenne {2}\u202F% où elle n’est pas nulle\u202F: "
     "elle mesure le nombre de calculs, non la qualité avec laquelle modèle, terrain et distributions décrivent la "
     "nature.",
     "El error estándar de las probabilidades es como máximo {1} %, en promedio {2} % donde no es 0: mide el número de "
     "simulaciones, no lo bien que modelo, terreno y distribuciones describen la naturaleza."},
    {"The error asked for (study.until = {1}) is reached.", "L’errore richiesto (study.until = {1}) è raggiunto.",
     "Der verlangte Fehler (study.until = {1}) ist erreicht.", "L’erreur demandée (study.until = {1}) est atteinte.",
     "El error pedido (study.until = {1}) se alcanza."},
    {"The error asked for (study.until = {1}) is not reached.",
     "L’errore richiesto (study.until = {1}) non è raggiunto.",
     "Der verlangte Fehler (study.until = {1}) ist nicht erreicht.",
     "L’erreur demandée (study.until = {1}) n’est pas atteinte.", "El error pedido (study.until = {1}) no se alcanza."},
    {"Each source is computed with one set of values, not with the range of what is possible.",
     "Ogni sorgente è calcolata con un solo insieme di valori, non con il campo di ciò che è possibile.",
     "Jedes Anrissgebiet ist mit einem Satz von Werten gerechnet, nicht mit der Spanne des Möglichen.",
     "Chaque zone de départ est calculée avec un seul jeu de valeurs, non avec l’étendue du possible.",
     "Cada área de inicio se calcula con un solo conjunto de valores, no con el rango de lo posible."},
    {"Only what is named here is varied: errors of the model, of the terrain and of other values are in no "
     "probability.",
     "Varia solo ciò che è nominato qui: errori del modello, del terreno e di altri valori non sono in alcuna "
     "probabilità.",
     "Nur das hier Genannte variiert: Fehler des Modells, des Geländes und anderer Werte stecken in keiner "
     "Wahrscheinlichkeit.",
     "Seul varie ce qui est nommé ici\u202F: les erreurs du modèle, du terrain et d’autres valeurs ne sont dans aucune "
     "probabilité.",
     "Solo varía lo que aquí se nombra: errores del modelo, del terreno y de otros valores no están en ninguna "
     "probabilidad."},
    {"Values of the runs: mean, and what 5, 50 and 95 % of them do not exceed",
     "Valori delle simulazioni: media, e ciò che il 5, 50 e 95 % di esse non supera",
     "Werte der Läufe: Mittel, und was 5, 50 und 95 % von ihnen nicht überschreiten",
     "Valeurs des calculs\u202F: moyenne, et ce que 5, 50 et 95\u202F% d’entre eux ne dépassent pas",
     "Valores de las simulaciones: media, y lo que el 5, 50 y 95 % de ellas no supera"},
    {"mean", "media", "Mittel", "moyenne", "media"},
    {"source", "sorgente", "Anrissgebiet", "zone de départ", "área de inicio"},
    {"Sources", "Sorgenti", "Anrissgebiete", "Zones de départ", "Áreas de inicio"},
    {"The {1} that come farthest; members.csv has all.", "Le {1} che arrivano più lontano; members.csv le ha tutte.",
     "Die {1}, die am weitesten kommen; members.csv hat alle.",
     "Les {1} qui vont le plus loin\u202F; members.csv les contient toutes.",
     "Las {1} que llegan más lejos; members.csv las tiene todas."},
    // Tables: src/app/ensemble/study_report.cpp.
    {"distribution", "distribuzione", "Verteilung", "distribution", "distribución"},
    {"rank correlation", "correlazione di rango", "Rangkorrelation", "corrélation de rang", "correlación de rango"},
    {"rank correlation {1}", "correlazione di rango {1}", "Rangkorrelation {1}", "corrélation de rang {1}",
     "correlación de rango {1}"},
    {"level", "livello", "Stufe", "niveau", "nivel"},
    {"variance of the difference, of that on level 0 [%]", "varianza della differenza, di quella al livello 0 [%]",
     "Varianz des Unterschieds, von der auf Stufe 0 [%]", "variance de la différence, de celle au niveau 0 [%]",
     "varianza de la diferencia, de la del nivel 0 [%]"},
    {"part of the cost [%]", "parte del costo [%]", "Anteil an den Kosten [%]", "part du coût [%]",
     "parte del coste [%]"},
    {"{1} ({2} to {3})", "{1} (da {2} a {3})", "{1} ({2} bis {3})", "{1} ({2} à {3})", "{1} ({2} a {3})"},
    {"first order", "primo ordine", "erste Ordnung", "premier ordre", "primer orden"},
    {"total", "totale", "gesamt", "total", "total"},
    {"method", "metodo", "Verfahren", "méthode", "método"},
    {"not measurable", "non misurabile", "nicht messbar", "non mesurable", "no medible"},
    {"What part of the variance of a value its key explains, alone (first order) and with others (total), or how the "
     "two are correlated; in brackets the interval of 95 %.",
     "Quale parte della varianza di un valore spiega la sua chiave, da sola (primo ordine) e con altre (totale), o "
     "come le due sono correlate; fra parentesi l’intervallo del 95 %.",
     "Welchen Teil der Varianz eines Werts sein Schlüssel erklärt, allein (erste Ordnung) und mit anderen (gesamt), "
     "oder wie beide korrelieren; in Klammern das 95-%-Intervall.",
     "Quelle part de la variance d’une valeur sa clé explique, seule (premier ordre) et avec d’autres (total), ou "
     "comment les deux sont corrélées\u202F; entre parenthèses l’intervalle à 95\u202F%.",
     "Qué parte de la varianza de un valor explica su clave, sola (primer orden) y con otras (total), o cómo se "
     "correlacionan ambas; entre paréntesis el intervalo del 95 %."},
    {"Member {1}: {2} {3} {4}, nearest to the weighted median of all, {5}. Its values: {6}.",
     "Simulazione {1}: {2} {3} {4}, la più vicina alla mediana pesata di tutte, {5}. I suoi valori: {6}.",
     "Lauf {1}: {2} {3} {4}, am nächsten am gewichteten Median aller, {5}. Seine Werte: {6}.",
     "Calcul {1}\u202F: {2} {3} {4}, le plus proche de la médiane pondérée de tous, {5}. Ses valeurs\u202F: {6}.",
     "Simulación {1}: {2} {3} {4}, la más cercana a la mediana ponderada de todas, {5}. Sus valores: {6}."},
    {"Film of this member", "Film di questa simulazione", "Film dieses Laufs", "Film de ce calcul",
     "Película de esta simulación"},
    {"member", "simulazione", "Lauf", "calcul", "simulación"},
    {"reason", "motivo", "Grund", "raison", "razón"},
});

}  // namespace

std::span<const WordRow> study_report_words() {
    return k_study_report_words;
}

}  // namespace frana
