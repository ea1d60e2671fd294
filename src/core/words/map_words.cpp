// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "core/words/word_row.h"

namespace frana {
namespace {

constexpr auto k_rows = std::to_array<WordRow>({
    // Furniture of a page. Letters: east and west, north and south.
    {"EW", "EO", "EW", "EO", "EO"},
    {"true north {1}° east of grid north", "nord geografico {1}° a est del nord di quadrettatura",
     "geografisch Nord {1}° östlich von Gitternord", "nord géographique à {1}° à l’est du nord du quadrillage",
     "norte geográfico {1}° al este del norte de cuadrícula"},
    {"true north {1}° west of grid north", "nord geografico {1}° a ovest del nord di quadrettatura",
     "geografisch Nord {1}° westlich von Gitternord", "nord géographique à {1}° à l’ouest du nord du quadrillage",
     "norte geográfico {1}° al oeste del norte de cuadrícula"},
    {"contour interval {1} m", "equidistanza delle curve di livello {1} m", "Äquidistanz der Höhenlinien {1} m",
     "équidistance des courbes de niveau {1} m", "equidistancia de las curvas de nivel {1} m"},
    {"nothing to show: the raster has no values", "nulla da mostrare: il raster non ha valori",
     "nichts darzustellen: das Raster hat keine Werte", "rien à montrer\u202F: le raster n’a pas de valeurs",
     "nada que mostrar: el ráster no tiene valores"},
    {"Simulated with {1}", "Simulato con {1}", "Simuliert mit {1}", "Simulé avec {1}", "Simulado con {1}"},
    {"Drawn with {1}", "Disegnato con {1}", "Dargestellt mit {1}", "Dessiné avec {1}", "Dibujado con {1}"},
    {"{1}, band {2}", "{1}, banda {2}", "{1}, Band {2}", "{1}, bande {2}", "{1}, banda {2}"},
    {"on {1}", "su {1}", "auf {1}", "sur {1}", "en {1}"},
    {"printed {1} × {2} cm", "stampata {1} × {2} cm", "gedruckt {1} × {2} cm", "imprimée {1} × {2} cm",
     "impreso {1} × {2} cm"},
    {"Base map", "Carta di base", "Hintergrundkarte", "Fond de carte", "Mapa base"},
    {"t = {1} s", "t = {1} s", "t = {1} s", "t = {1} s", "t = {1} s"},

    // What was computed.
    {"Model unknown", "Modello sconosciuto", "Modell unbekannt", "Modèle inconnu", "Modelo desconocido"},
    {"Structured model", "Modello strutturato", "Strukturiertes Modell", "Modèle structuré", "Modelo estructurado"},
    {"Voellmy-Bingham, scheme {1}", "Voellmy-Bingham, schema {1}", "Voellmy-Bingham, Schema {1}",
     "Voellmy-Bingham, schéma {1}", "Voellmy-Bingham, esquema {1}"},
    {"{1}, {2} s simulated", "{1}, {2} s simulati", "{1}, {2} s simuliert", "{1}, {2} s simulées",
     "{1}, {2} s simulados"},
    {"run under way, {1} s simulated so far", "calcolo in corso, finora simulati {1} s",
     "Berechnung läuft, bisher {1} s simuliert", "calcul en cours, {1} s simulées jusqu’ici",
     "cálculo en curso, {1} s simulados hasta ahora"},
    {"{1} sources, each failing alone", "{1} sorgenti, ciascuna franata da sola",
     "{1} Anrissgebiete, jedes bricht allein los", "{1} zones de départ, chacune rompant seule",
     "{1} áreas de inicio, cada una falla por separado"},
    {"{1} runs with values drawn from their distributions", "{1} simulazioni con valori estratti dalle distribuzioni",
     "{1} Läufe mit Werten aus ihren Verteilungen", "{1} calculs avec valeurs tirées de leurs distributions",
     "{1} simulaciones con valores extraídos de sus distribuciones"},
    {"{1} more runs failed", "altre {1} simulazioni fallite", "{1} weitere Läufe gescheitert",
     "{1} autres calculs ont échoué", "otras {1} simulaciones fallidas"},
    {"Standard error of the probabilities at most {1} %", "Errore standard delle probabilità al più {1} %",
     "Standardfehler der Wahrscheinlichkeiten höchstens {1} %", "Erreur type des probabilités au plus {1}\u202F%",
     "Error estándar de las probabilidades como máximo {1} %"},

    // The scenario: what fails, and the values of its model.
    {"bed friction {1}", "attrito al fondo {1}", "Sohlreibung {1}", "frottement au lit {1}", "fricción del lecho {1}"},
    {"{1} by place", "{1} secondo il luogo", "{1} je nach Ort", "{1} selon le lieu", "{1} según el lugar"},
    {"no turbulence", "senza turbolenza", "ohne Turbulenz", "sans turbulence", "sin turbulencia"},
    {"bed friction angle", "angolo di attrito al fondo", "Sohlreibungswinkel", "angle de frottement au lit",
     "ángulo de fricción del lecho"},
    {"grain density", "densità dei grani", "Korndichte", "masse volumique des grains", "densidad de los granos"},
    {"solid fraction", "frazione solida", "Feststoffanteil", "fraction solide", "fracción sólida"},

    // The difference of two results, A and B.
    {"Difference", "Differenza", "Differenz", "Différence", "Diferencia"},
    {"A minus B", "A meno B", "A minus B", "A moins B", "A menos B"},
    {"where both came", "dove sono giunti entrambi", "wo beide ankamen", "là où les deux sont arrivés",
     "donde llegaron ambos"},
    {"0 where one did not come", "0 dove uno non è giunto", "0, wo einer nicht ankam", "0 là où l’un n’est pas arrivé",
     "0 donde uno no llegó"},
    {"Release of B", "Area di distacco di B", "Anrissgebiet von B", "Zone de départ de B", "Área de inicio de B"},
    {"{1}, minus the same of B", "{1}, meno lo stesso di B", "{1}, minus dasselbe von B", "{1}, moins le même de B",
     "{1}, menos el mismo de B"},

    // Values beside the map.
    {"Volume {1} m³", "Volume {1} m³", "Volumen {1} m³", "Volume {1} m³", "Volumen {1} m³"},
    {"Covered {1} m²", "Area coperta {1} m²", "Bedeckt {1} m²", "Surface couverte {1} m²", "Área cubierta {1} m²"},
    {"(deeper than {1} m)", "(profondità oltre {1} m)", "(tiefer als {1} m)", "(hauteur de plus de {1} m)",
     "(profundidad de más de {1} m)"},
    {"Run-out {1} m", "Distanza di propagazione {1} m", "Auslauflänge {1} m", "Distance de propagation {1} m",
     "Alcance {1} m"},
    {"Drop {1} m", "Dislivello {1} m", "Fallhöhe {1} m", "Dénivelé {1} m", "Desnivel {1} m"},
    {"Angle of reach {1}°", "Angolo di propagazione {1}°", "Pauschalgefälle {1}°", "Angle de propagation {1}°",
     "Ángulo de alcance {1}°"},
    {"(longest of {1} flows)", "(la più lunga di {1} colate)", "(längster von {1} Strömen)",
     "(le plus long de {1} écoulements)", "(el más largo de {1} flujos)"},
    {"Still moving at the end", "Ancora in moto alla fine", "Am Ende noch in Bewegung", "Encore en mouvement à la fin",
     "Aún en movimiento al final"},
    {"{1} m³ left the map", "{1} m³ usciti dalla mappa", "{1} m³ verließen die Karte", "{1} m³ sortis de la carte",
     "{1} m³ salieron del mapa"},
    {"Covers {1} m²", "Copre {1} m²", "Bedeckt {1} m²", "Couvre {1} m²", "Cubre {1} m²"},
    {"Front at {1} m", "Fronte a {1} m", "Front bei {1} m", "Front à {1} m", "Frente a {1} m"},
    {"Greatest speed {1} m/s", "Velocità massima {1} m/s", "Größte Geschwindigkeit {1} m/s", "Vitesse maximale {1} m/s",
     "Velocidad máxima {1} m/s"},
    {"{1} particles", "{1} particelle", "{1} Partikel", "{1} particules", "{1} partículas"},
    {"Only above {1}", "Solo oltre {1}", "Nur über {1}", "Seulement au-dessus de {1}", "Solo por encima de {1}"},
    {"Threshold {1} m", "Soglia {1} m", "Schwellenwert {1} m", "Seuil {1} m", "Umbral {1} m"},
    {"Area difference {1} %", "Differenza di area {1} %", "Flächendifferenz {1} %", "Différence de surface {1}\u202F%",
     "Diferencia de área {1} %"},
    {"Jaccard {1}", "Jaccard {1}", "Jaccard {1}", "Jaccard {1}", "Jaccard {1}"},
    {"Dice {1}", "Dice {1}", "Dice {1}", "Dice {1}", "Dice {1}"},

    // Lines and areas in the legend.
    {"Release", "Area di distacco", "Anrissgebiet", "Zone de départ", "Área de inicio"},
    {"Observed outline", "Perimetro rilevato", "Kartierter Umriss", "Contour levé", "Contorno levantado"},
    {"Friction zones", "Zone di attrito", "Reibungszonen", "Zones de frottement", "Zonas de fricción"},
    {"Obstacles", "Ostacoli", "Hindernisse", "Obstacles", "Obstáculos"},
    {"Walls", "Muri", "Mauern", "Murs", "Muros"},
    {"Profiles", "Profili", "Längenprofile", "Profils", "Perfiles"},
    {"Exposed places", "Luoghi esposti", "Gefährdete Orte", "Lieux exposés", "Lugares expuestos"},
    {"Exposed lines", "Linee esposte", "Gefährdete Linien", "Lignes exposées", "Líneas expuestas"},
    {"Exposed areas", "Aree esposte", "Gefährdete Flächen", "Surfaces exposées", "Áreas expuestas"},
    {"Cross-sections", "Sezioni", "Querschnitte", "Sections", "Secciones"},
    {"Gauges", "Punti di misura", "Messpunkte", "Points de mesure", "Puntos de medida"},
    {"Reached by {1} %", "Raggiunto dal {1} %", "Erreicht von {1} %", "Atteint par {1}\u202F%",
     "Alcanzado por el {1} %"},

    // Views.
    {"view to the {1}", "vista verso {1}", "Blick nach {1}", "vue vers {1}", "vista hacia {1}"},
    {"heights true to scale", "altezze in scala reale", "Höhen nicht überhöht", "hauteurs à l’échelle réelle",
     "alturas a escala real"},
    {"heights exaggerated {1} times", "altezze esagerate {1} volte", "Höhen {1}-fach überhöht",
     "hauteurs exagérées {1} fois", "alturas exageradas {1} veces"},
    {"N", "N", "N", "N", "N"},
    {"NNE", "NNE", "NNO", "NNE", "NNE"},
    {"NE", "NE", "NO", "NE", "NE"},
    {"ENE", "ENE", "ONO", "ENE", "ENE"},
    {"E", "E", "O", "E", "E"},
    {"ESE", "ESE", "OSO", "ESE", "ESE"},
    {"SE", "SE", "SO", "SE", "SE"},
    {"SSE", "SSE", "SSO", "SSE", "SSE"},
    {"S", "S", "S", "S", "S"},
    {"SSW", "SSO", "SSW", "SSO", "SSO"},
    {"SW", "SO", "SW", "SO", "SO"},
    {"WSW", "OSO", "WSW", "OSO", "OSO"},
    {"W", "O", "W", "O", "O"},
    {"WNW", "ONO", "WNW", "ONO", "ONO"},
    {"NW", "NO", "NW", "NO", "NO"},
    {"NNW", "NNO", "NNW", "NNO", "NNO"},

    // Months, and a date of day, month, year.
    {"{1} {2} {3}", "{1} {2} {3}", "{1}. {2} {3}", "{1} {2} {3}", "{1} de {2} de {3}"},
    {"January", "gennaio", "Januar", "janvier", "enero"},
    {"February", "febbraio", "Februar", "février", "febrero"},
    {"March", "marzo", "März", "mars", "marzo"},
    {"April", "aprile", "April", "avril", "abril"},
    {"May", "maggio", "Mai", "mai", "mayo"},
    {"June", "giugno", "Juni", "juin", "junio"},
    {"July", "luglio", "Juli", "juillet", "julio"},
    {"August", "agosto", "August", "août", "agosto"},
    {"September", "settembre", "September", "septembre", "septiembre"},
    {"October", "ottobre", "Oktober", "octobre", "octubre"},
    {"November", "novembre", "November", "novembre", "noviembre"},
    {"December", "dicembre", "Dezember", "décembre", "diciembre"},
});

}  // namespace

std::span<const WordRow> map_words() {
    return k_rows;
}

}  // namespace frana
