// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "core/words/word_row.h"

namespace frana {
namespace {

constexpr auto k_calibration_words = std::to_array<WordRow>({
    // The report of a calibration: src/app/calibrate/calibration_report.cpp.
    {"{1}: calibration", "{1}: calibrazione", "{1}: Kalibrierung", "{1}\u202F: calage", "{1}: calibración"},
    {"Values and answer", "Valori e risposta", "Werte und Antwort", "Valeurs et réponse", "Valores y respuesta"},
    {"{1} to {2}", "da {1} a {2}", "{1} bis {2}", "{1} à {2}", "{1} a {2}"},
    {"{1} of {2}", "{1} di {2}", "{1} von {2}", "{1} de {2}", "{1} de {2}"},
    {"distribution before", "distribuzione prima", "Verteilung vorher", "distribution avant", "distribución antes"},
    {"median", "mediana", "Median", "médiane", "mediana"},
    {"90 % after", "90 % dopo", "90 % nachher", "90\u202F% après", "90 % después"},
    {"width, of that before", "ampiezza, di quella prima", "Breite, von der vorher", "largeur, de celle d’avant",
     "anchura, de la de antes"},
    {"no member finished", "nessuna simulazione è terminata", "kein Lauf ist beendet", "aucun calcul n’est terminé",
     "ninguna simulación terminó"},
    {"event", "evento", "Ereignis", "événement", "evento"},
    {"values", "valori", "Werte", "valeurs", "valores"},
    {"score of the best", "punteggio della migliore", "Gütemaß des besten", "score du meilleur",
     "puntuación de la mejor"},
    {"5 to 95 %", "dal 5 al 95 %", "5 bis 95 %", "5 à 95\u202F%", "5 a 95 %"},
    {"effective members", "simulazioni efficaci", "wirksame Läufe", "calculs effectifs", "simulaciones efectivas"},
    {"fitted to all surveys", "adattati a tutti i rilievi", "an alle Kartierungen angepasst",
     "ajustées à tous les levés", "ajustados a todos los levantamientos"},
    {"from the other surveys alone", "dai soli altri rilievi", "aus den anderen Kartierungen allein",
     "des autres levés seuls", "solo de los otros levantamientos"},
    {"measure", "misura", "Maß", "mesure", "medida"},
    {"weight", "peso", "Gewicht", "poids", "peso"},
    {"misfit of the best", "scarto della migliore", "Abweichung des besten", "écart du meilleur",
     "desajuste de la mejor"},
    {"formula", "formula", "Formel", "formule", "fórmula"},
    {"What the surveys say.", "Che cosa dicono i rilievi.", "Was die Kartierungen sagen.", "Ce que disent les levés.",
     "Qué dicen los levantamientos."},
    {"How well the events are explained.", "Quanto bene sono spiegati gli eventi.",
     "Wie gut die Ereignisse erklärt werden.", "Comment les événements sont expliqués.",
     "Cuán bien se explican los eventos."},
    {"How well the events are explained", "Quanto bene sono spiegati gli eventi",
     "Wie gut die Ereignisse erklärt werden", "Comment les événements sont expliqués",
     "Cuán bien se explican los eventos"},
    {"A score is 1 minus the misfit: 1 agrees.", "Un punteggio è 1 meno lo scarto: 1 concorda.",
     "Ein Gütemaß ist 1 minus die Abweichung: 1 stimmt überein.", "Un score est 1 moins l’écart\u202F: 1 concorde.",
     "Una puntuación es 1 menos el desajuste: 1 coincide."},
    {"{1}: {2} fitted, {3} predicted from the other events.", "{1}: {2} adattato, {3} previsto dagli altri eventi.",
     "{1}: {2} angepasst, {3} aus den anderen Ereignissen vorhergesagt.",
     "{1}\u202F: {2} ajusté, {3} prédit à partir des autres événements.",
     "{1}: {2} ajustado, {3} predicho a partir de los otros eventos."},
    {"{1}: {2} fitted.", "{1}: {2} adattato.", "{1}: {2} angepasst.", "{1}\u202F: {2} ajusté.", "{1}: {2} ajustado."},
    {"With one event there is no forecast to check: the score is that of a fit.",
     "Con un solo evento non c’è previsione da verificare: il punteggio è quello di un adattamento.",
     "Mit einem Ereignis gibt es keine Vorhersage zu prüfen: das Gütemaß ist das einer Anpassung.",
     "Avec un seul événement il n’y a pas de prévision à vérifier\u202F: le score est celui d’un ajustement.",
     "Con un solo evento no hay predicción que comprobar: la puntuación es la de un ajuste."},
    {"{1} first members, then {2} where these explain the surveys, on cells of {3} m; effective number {4}. Likelihood "
     "of an event: misfit to the power of -{5}.",
     "{1} prime simulazioni, poi {2} dove queste spiegano i rilievi, su celle di {3} m; numero efficace {4}. "
     "Verosimiglianza di un evento: scarto elevato a -{5}.",
     "{1} erste Läufe, dann {2}, wo diese die Kartierungen erklären, auf Zellen von {3} m; wirksame Anzahl {4}. "
     "Likelihood eines Ereignisses: Abweichung hoch -{5}.",
     "{1} premiers calculs, puis {2} là où ceux-ci expliquent les levés, sur des mailles de {3} m\u202F; nombre "
     "effectif {4}. Vraisemblance d’un événement\u202F: écart à la puissance -{5}.",
     "{1} primeras simulaciones, luego {2} donde estas explican los levantamientos, en celdas de {3} m; número "
     "efectivo {4}. Verosimilitud de un evento: desajuste elevado a -{5}."},
    {"{1} runs failed and have no weight.", "{1} calcoli sono falliti e non hanno peso.",
     "{1} Rechnungen scheiterten und haben kein Gewicht.", "{1} calculs ont échoué et n’ont pas de poids.",
     "{1} cálculos fallaron y no tienen peso."},
    {"The values fit these events with this model; another place, another size or another model needs its own "
     "calibration.",
     "I valori si adattano a questi eventi con questo modello; un altro luogo, un’altra dimensione o un altro modello "
     "richiede una propria calibrazione.",
     "Die Werte passen zu diesen Ereignissen mit diesem Modell; ein anderer Ort, eine andere Größe oder ein anderes "
     "Modell braucht eine eigene Kalibrierung.",
     "Les valeurs conviennent à ces événements avec ce modèle\u202F; un autre lieu, une autre taille ou un autre "
     "modèle demande son propre calage.",
     "Los valores se ajustan a estos eventos con este modelo; otro lugar, otro tamaño u otro modelo necesita su propia "
     "calibración."},
    // What the surveys say: src/study/calibration_posterior.cpp.
    {"With the surveys {1} is {2} to {3} (90 %): {4} % of the width that it has without them.",
     "Con i rilievi {1} è da {2} a {3} (90 %): il {4} % dell’ampiezza che ha senza di essi.",
     "Mit den Kartierungen ist {1} {2} bis {3} (90 %): {4} % der Breite, die es ohne sie hat.",
     "Avec les levés {1} va de {2} à {3} (90\u202F%)\u202F: {4}\u202F% de la largeur qu’elle a sans eux.",
     "Con los levantamientos {1} va de {2} a {3} (90 %): el {4} % de la anchura que tiene sin ellos."},
    {"The surveys cannot tell {1} from {2}: greater values of one explain them as well with greater values of the "
     "other (correlation {3}).",
     "I rilievi non distinguono {1} da {2}: valori maggiori dell’uno li spiegano altrettanto bene con valori maggiori "
     "dell’altro (correlazione {3}).",
     "Die Kartierungen unterscheiden {1} nicht von {2}: größere Werte des einen erklären sie ebenso gut mit größeren "
     "Werten des anderen (Korrelation {3}).",
     "Les levés ne distinguent pas {1} de {2}\u202F: de plus grandes valeurs de l’un les expliquent aussi bien avec de "
     "plus grandes valeurs de l’autre (corrélation {3}).",
     "Los levantamientos no distinguen {1} de {2}: valores mayores de uno los explican igual de bien con valores "
     "mayores del otro (correlación {3})."},
    {"The surveys cannot tell {1} from {2}: greater values of one explain them as well with smaller values of the "
     "other (correlation {3}).",
     "I rilievi non distinguono {1} da {2}: valori maggiori dell’uno li spiegano altrettanto bene con valori minori "
     "dell’altro (correlazione {3}).",
     "Die Kartierungen unterscheiden {1} nicht von {2}: größere Werte des einen erklären sie ebenso gut mit kleineren "
     "Werten des anderen (Korrelation {3}).",
     "Les levés ne distinguent pas {1} de {2}\u202F: de plus grandes valeurs de l’un les expliquent aussi bien avec de "
     "plus petites valeurs de l’autre (corrélation {3}).",
     "Los levantamientos no distinguen {1} de {2}: valores mayores de uno los explican igual de bien con valores "
     "menores del otro (correlación {3})."},
    {"The posterior rests on few members (effective number {1}): its intervals are rough. Raise study.refine.",
     "La distribuzione a posteriori poggia su poche simulazioni (numero efficace {1}): i suoi intervalli sono "
     "approssimativi. Aumentare study.refine.",
     "Die A-posteriori-Verteilung ruht auf wenigen Läufen (wirksame Anzahl {1}): ihre Intervalle sind grob. "
     "study.refine erhöhen.",
     "La distribution a posteriori repose sur peu de calculs (nombre effectif {1})\u202F: ses intervalles sont "
     "grossiers. Augmenter study.refine.",
     "La distribución a posteriori se apoya en pocas simulaciones (número efectivo {1}): sus intervalos son "
     "aproximados. Aumente study.refine."},
    {"Few of the members explain the surveys: the exponent of the likelihood is lowered from {1} to {2} so that {3} of "
     "them count. The intervals are wider than the surveys allow; raise study.refine.",
     "Poche simulazioni spiegano i rilievi: l’esponente della verosimiglianza è ridotto da {1} a {2} perché ne contino "
     "{3}. Gli intervalli sono più ampi di quanto i rilievi permettano; aumentare study.refine.",
     "Wenige der Läufe erklären die Kartierungen: der Exponent der Likelihood ist von {1} auf {2} gesenkt, damit {3} "
     "von ihnen zählen. Die Intervalle sind breiter, als die Kartierungen erlauben; study.refine erhöhen.",
     "Peu de calculs expliquent les levés\u202F: l’exposant de la vraisemblance est abaissé de {1} à {2} pour que {3} "
     "d’entre eux comptent. Les intervalles sont plus larges que les levés ne le permettent\u202F; augmenter "
     "study.refine.",
     "Pocas simulaciones explican los levantamientos: el exponente de la verosimilitud se reduce de {1} a {2} para que "
     "cuenten {3} de ellas. Los intervalos son más anchos de lo que permiten los levantamientos; aumente "
     "study.refine."},
    // Measures: src/study/calibration_spec.h. r(a, b) is the relative difference.
    {"1 - Jaccard index of trace and surveyed outline", "1 - indice di Jaccard di traccia e perimetro osservato",
     "1 - Jaccard-Index von Spur und beobachtetem Umriss", "1 - indice de Jaccard de la trace et du contour observé",
     "1 - índice de Jaccard de traza y contorno observado"},
    {"r(area of the trace, surveyed area)", "r(area della traccia, area osservata)",
     "r(Fläche der Spur, beobachtete Fläche)", "r(surface de la trace, surface observée)",
     "r(área de la traza, área observada)"},
    {"r(simulated run-out, observed run-out)", "r(distanza simulata, distanza osservata)",
     "r(simulierte Auslauflänge, beobachtete)", "r(distance simulée, distance observée)",
     "r(alcance simulado, alcance observado)"},
    {"d / (d + R): d mean distance of both outlines, R radius of a circle with the surveyed area",
     "d / (d + R): d distanza media dei due perimetri, R raggio di un cerchio con l’area osservata",
     "d / (d + R): d mittlerer Abstand beider Umrisse, R Radius eines Kreises mit der beobachteten Fläche",
     "d / (d + R)\u202F: d distance moyenne des deux contours, R rayon d’un cercle de la surface observée",
     "d / (d + R): d distancia media de ambos contornos, R radio de un círculo con el área observada"},
    {"1 - Jaccard index of simulated and surveyed deposit", "1 - indice di Jaccard di deposito simulato e rilevato",
     "1 - Jaccard-Index von simulierter und kartierter Ablagerung",
     "1 - indice de Jaccard du dépôt simulé et du dépôt levé",
     "1 - índice de Jaccard de depósito simulado y levantado"},
    {"sum |h - h_obs| / sum (h + h_obs) over the cells of either deposit",
     "somma |h - h_oss| / somma (h + h_oss) sulle celle dell’uno o dell’altro deposito",
     "Summe |h - h_beob| / Summe (h + h_beob) über die Zellen beider Ablagerungen",
     "somme |h - h_obs| / somme (h + h_obs) sur les mailles de l’un ou l’autre dépôt",
     "suma |h - h_obs| / suma (h + h_obs) sobre las celdas de uno u otro depósito"},
    {"mean over gauges of r(arrival time, observed one); 1: no arrival",
     "media sui punti di misura di r(tempo di arrivo, quello osservato); 1: nessun arrivo",
     "Mittel über die Messpunkte von r(Ankunftszeit, beobachtete); 1: keine Ankunft",
     "moyenne sur les points de mesure de r(temps d’arrivée, celui observé)\u202F; 1\u202F: pas d’arrivée",
     "media sobre los puntos de medida de r(tiempo de llegada, el observado); 1: sin llegada"},
    {"mean over gauges of r(greatest speed, observed one)",
     "media sui punti di misura di r(velocità massima, quella osservata)",
     "Mittel über die Messpunkte von r(größte Geschwindigkeit, beobachtete)",
     "moyenne sur les points de mesure de r(vitesse maximale, celle observée)",
     "media sobre los puntos de medida de r(velocidad máxima, la observada)"},
    {"mean over gauges of r(greatest depth, observed one)",
     "media sui punti di misura di r(profondità massima, quella osservata)",
     "Mittel über die Messpunkte von r(größte Fließtiefe, beobachtete)",
     "moyenne sur les points de mesure de r(hauteur maximale, celle observée)",
     "media sobre los puntos de medida de r(profundidad máxima, la observada)"},
    // A map of probability against a survey: src/app/publish/report_probability.cpp.
    {"{1}: Brier score {2} (0: perfect), skill {3} (1: perfect, 0: as good as the mean everywhere), area under the ROC "
     "curve {4} (1: perfect).",
     "{1}: punteggio di Brier {2} (0: perfetto), abilità {3} (1: perfetto, 0: buono come la media ovunque), area sotto "
     "la curva ROC {4} (1: perfetto).",
     "{1}: Brier-Score {2} (0: perfekt), Skill {3} (1: perfekt, 0: so gut wie überall der Mittelwert), Fläche unter "
     "der ROC-Kurve {4} (1: perfekt).",
     "{1}\u202F: score de Brier {2} (0\u202F: parfait), compétence {3} (1\u202F: parfait, 0\u202F: aussi bon que la "
     "moyenne partout), aire sous la courbe ROC {4} (1\u202F: parfait).",
     "{1}: puntuación de Brier {2} (0: perfecto), destreza {3} (1: perfecto, 0: tan buena como la media en todas "
     "partes), área bajo la curva ROC {4} (1: perfecto)."},
    {"Brier score, best 0", "Punteggio di Brier, migliore 0", "Brier-Score, am besten 0", "Score de Brier, meilleur 0",
     "Puntuación de Brier, mejor 0"},
    {"Brier skill, best 1", "Abilità di Brier, migliore 1", "Brier-Skill, am besten 1",
     "Compétence de Brier, meilleure 1", "Destreza de Brier, mejor 1"},
    {"Reliability: how far the probabilities are from those observed, best 0",
     "Affidabilità: quanto le probabilità distano da quelle osservate, migliore 0",
     "Zuverlässigkeit: wie weit die Wahrscheinlichkeiten von den beobachteten liegen, am besten 0",
     "Fiabilité\u202F: écart des probabilités à celles observées, meilleur 0",
     "Fiabilidad: cuánto distan las probabilidades de las observadas, mejor 0"},
    {"Resolution: how far they differ from the mean", "Risoluzione: quanto si discostano dalla media",
     "Auflösung: wie weit sie vom Mittel abweichen", "Résolution\u202F: combien elles s’écartent de la moyenne",
     "Resolución: cuánto se apartan de la media"},
    {"Reliability of the probabilities, and their ROC curve with an area of {1}",
     "Affidabilità delle probabilità, e la loro curva ROC con area {1}",
     "Zuverlässigkeit der Wahrscheinlichkeiten und ihre ROC-Kurve mit der Fläche {1}",
     "Fiabilité des probabilités, et leur courbe ROC d’aire {1}",
     "Fiabilidad de las probabilidades, y su curva ROC de área {1}"},
});

}  // namespace

std::span<const WordRow> calibration_words() {
    return k_calibration_words;
}

}  // namespace frana
