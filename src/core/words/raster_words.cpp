// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "core/words/word_row.h"

namespace frana {
namespace {

// The titles of src/params/keys/result_rasters.cpp, where {} is {1} here, and of particles.
constexpr auto k_rows = std::to_array<WordRow>({
    {"Maximum depth", "Profondità massima", "Maximale Fließtiefe", "Hauteur d’écoulement maximale",
     "Profundidad máxima"},
    {"Maximum velocity", "Velocità massima", "Maximale Fließgeschwindigkeit", "Vitesse maximale", "Velocidad máxima"},
    {"Final depth", "Profondità finale", "Ablagerungshöhe am Ende", "Hauteur finale", "Profundidad final"},
    {"Arrival time", "Tempo di arrivo", "Ankunftszeit", "Temps d’arrivée", "Tiempo de llegada"},
    {"Maximum dynamic pressure", "Pressione dinamica massima", "Maximaler dynamischer Druck",
     "Pression dynamique maximale", "Presión dinámica máxima"},
    {"Thickness released", "Spessore mobilizzato", "Anrissmächtigkeit", "Épaisseur mobilisée", "Espesor movilizado"},
    {"Terrain", "Terreno", "Gelände", "Terrain", "Terreno"},
    {"Bed", "Superficie di scivolamento", "Gleitfläche", "Surface de glissement", "Superficie de deslizamiento"},
    {"Intensity", "Intensità", "Intensität", "Intensité", "Intensidad"},
    {"Maximum flux", "Flusso specifico massimo", "Maximaler spezifischer Abfluss", "Débit spécifique maximal",
     "Caudal específico máximo"},
    {"Maximum energy head", "Altezza energetica massima", "Maximale Energiehöhe", "Hauteur d’énergie maximale",
     "Altura de energía máxima"},
    {"Eroded depth", "Profondità erosa", "Erosionstiefe", "Profondeur érodée", "Profundidad erosionada"},
    {"Deposited depth", "Spessore depositato", "Ablagerungsmächtigkeit", "Épaisseur déposée", "Espesor depositado"},
    {"Height of jumps", "Altezza dei salti", "Sprunghöhe", "Hauteur des sauts", "Altura de los saltos"},
    {"Velocity of the fluid", "Velocità del fluido", "Geschwindigkeit der Flüssigkeit", "Vitesse du fluide",
     "Velocidad del fluido"},
    {"Depth of free fluid", "Profondità del fluido libero", "Tiefe der freien Flüssigkeit", "Hauteur du fluide libre",
     "Profundidad del fluido libre"},
    {"Depth of solids", "Spessore dei solidi", "Mächtigkeit der Feststoffe", "Épaisseur des solides",
     "Espesor de los sólidos"},
    {"Solid fraction", "Frazione solida", "Feststoffanteil", "Fraction solide", "Fracción sólida"},
    {"Cohesion left", "Coesione residua", "Verbleibende Kohäsion", "Cohésion restante", "Cohesión restante"},
    {"Strain", "Deformazione", "Dehnung", "Déformation", "Deformación"},
    {"Velocity of the solids", "Velocità dei solidi", "Geschwindigkeit der Feststoffe", "Vitesse des solides",
     "Velocidad de los sólidos"},
    {"Released fluid", "Fluido rilasciato", "Freigesetzte Flüssigkeit", "Fluide libéré", "Fluido liberado"},
    {"Comparison with the survey", "Confronto con il rilievo", "Vergleich mit der Kartierung",
     "Comparaison avec le levé", "Comparación con el levantamiento"},
    {"Flow depth", "Profondità del flusso", "Fließtiefe", "Hauteur d’écoulement", "Profundidad del flujo"},
    {"Flow velocity", "Velocità del flusso", "Fließgeschwindigkeit", "Vitesse d’écoulement", "Velocidad del flujo"},
    {"Probability of more than {1} m", "Probabilità di oltre {1} m", "Wahrscheinlichkeit von mehr als {1} m",
     "Probabilité de plus de {1} m", "Probabilidad de más de {1} m"},
    {"Probability of more than {1} m/s", "Probabilità di oltre {1} m/s", "Wahrscheinlichkeit von mehr als {1} m/s",
     "Probabilité de plus de {1} m/s", "Probabilidad de más de {1} m/s"},
    {"Probability of more than {1} kPa", "Probabilità di oltre {1} kPa", "Wahrscheinlichkeit von mehr als {1} kPa",
     "Probabilité de plus de {1} kPa", "Probabilidad de más de {1} kPa"},
    {"Probability of intensity class {1} or higher", "Probabilità della classe di intensità {1} o superiore",
     "Wahrscheinlichkeit der Intensitätsklasse {1} oder höher", "Probabilité de la classe d’intensité {1} ou plus",
     "Probabilidad de la clase de intensidad {1} o superior"},
    {"Maximum depth, {1} % quantile", "Profondità massima, quantile {1} %", "Maximale Fließtiefe, {1}-%-Quantil",
     "Hauteur d’écoulement maximale, quantile {1}\u202F%", "Profundidad máxima, cuantil {1} %"},
    {"Maximum velocity, {1} % quantile", "Velocità massima, quantile {1} %",
     "Maximale Fließgeschwindigkeit, {1}-%-Quantil", "Vitesse maximale, quantile {1}\u202F%",
     "Velocidad máxima, cuantil {1} %"},
    {"Arrival time, {1} % quantile", "Tempo di arrivo, quantile {1} %", "Ankunftszeit, {1}-%-Quantil",
     "Temps d’arrivée, quantile {1}\u202F%", "Tiempo de llegada, cuantil {1} %"},
    {"Mean maximum depth", "Media della profondità massima", "Mittel der maximalen Fließtiefe",
     "Moyenne de la hauteur maximale", "Media de la profundidad máxima"},
    {"Deviation of the maximum depth", "Deviazione della profondità massima", "Streuung der maximalen Fließtiefe",
     "Écart type de la hauteur maximale", "Desviación de la profundidad máxima"},
    {"Mean maximum velocity", "Media della velocità massima", "Mittel der maximalen Fließgeschwindigkeit",
     "Moyenne de la vitesse maximale", "Media de la velocidad máxima"},
    {"Deviation of the maximum velocity", "Deviazione della velocità massima",
     "Streuung der maximalen Fließgeschwindigkeit", "Écart type de la vitesse maximale",
     "Desviación de la velocidad máxima"},
    {"Runs that arrived", "Simulazioni che arrivano", "Läufe, die ankamen", "Calculs ayant atteint le point",
     "Simulaciones que llegan"},
    {"Maximum depth of all sources", "Profondità massima di tutte le sorgenti",
     "Maximale Fließtiefe aller Anrissgebiete", "Hauteur maximale de toutes les zones de départ",
     "Profundidad máxima de todas las áreas de inicio"},
    {"Maximum velocity of all sources", "Velocità massima di tutte le sorgenti",
     "Maximale Fließgeschwindigkeit aller Anrissgebiete", "Vitesse maximale de toutes les zones de départ",
     "Velocidad máxima de todas las áreas de inicio"},
    {"Arrival time of the first source", "Tempo di arrivo della prima sorgente", "Ankunftszeit vom ersten Anrissgebiet",
     "Temps d’arrivée de la première zone de départ", "Tiempo de llegada de la primera área de inicio"},
    {"Number of the worst source", "Numero della sorgente peggiore", "Nummer des ungünstigsten Anrissgebiets",
     "Numéro de la zone de départ la plus défavorable", "Número del área de inicio más desfavorable"},
    {"Sensitivity to {1}", "Sensibilità a {1}", "Sensitivität gegenüber {1}", "Sensibilité à {1}",
     "Sensibilidad a {1}"},
    {"Estimated error of the maximum depth", "Errore stimato della profondità massima",
     "Geschätzter Fehler der maximalen Fließtiefe", "Erreur estimée de la hauteur maximale",
     "Error estimado de la profundidad máxima"},
    {"Speed of particles", "Velocità delle particelle", "Geschwindigkeit der Partikel", "Vitesse des particules",
     "Velocidad de las partículas"},
    {"Cohesion left of particles", "Coesione residua delle particelle", "Verbleibende Kohäsion der Partikel",
     "Cohésion restante des particules", "Cohesión restante de las partículas"},
});

}  // namespace

std::span<const WordRow> raster_words() {
    return k_rows;
}

}  // namespace frana
