<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>FiguresPanel</name>
    <message>
        <source>Values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>Red</source>
        <translation>Rot</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>Grün</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>Blau</translation>
    </message>
    <message>
        <source>Channel %1</source>
        <translation>Kanal %1</translation>
    </message>
</context>
<context>
    <name>MethodChooser</name>
    <message>
        <source>Not part of this build</source>
        <translation>Nicht in diesem Programm enthalten</translation>
    </message>
</context>
<context>
    <name>background</name>
    <message>
        <source>There is not enough memory for this; close an image or choose a smaller one.</source>
        <translation>Dafür reicht der Speicher nicht; schließen Sie ein Bild oder wählen Sie ein kleineres.</translation>
    </message>
</context>
<context>
    <name>core</name>
    <message>
        <source>A cut keeps every pixel as it is in the exemplar; blending mixes a band along the blocks&apos; edges, as in the source.</source>
        <translation>Ein Schnitt lässt jedes Pixel, wie es in der Vorlage ist; Überblenden mischt einen Streifen entlang der Blockkanten, wie in der Quelle.</translation>
    </message>
    <message>
        <source>A sample</source>
        <translation>Eine Stichprobe</translation>
    </message>
    <message>
        <source>A variant of the exemplar itself, or of an initial image: every patch is replaced by a random blend of the exemplar patches most like it. The layout stays.</source>
        <translation>Eine Variante der Vorlage selbst oder eines Startbilds: Jeder Patch wird durch eine zufällige Mischung der ähnlichsten Patches ersetzt. Die Anordnung bleibt.</translation>
    </message>
    <message>
        <source>ACEScg</source>
        <translation>ACEScg</translation>
    </message>
    <message>
        <source>Across channels</source>
        <translation>Über Kanäle hinweg</translation>
    </message>
    <message>
        <source>Advanced</source>
        <translation>Erweitert</translation>
    </message>
    <message>
        <source>Ambient occlusion</source>
        <translation>Umgebungsverdeckung</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>As given</source>
        <translation>Wie angegeben</translation>
    </message>
    <message>
        <source>As the exemplar&apos;s files</source>
        <translation>Wie die Dateien der Vorlage</translation>
    </message>
    <message>
        <source>Asymptotic spot noise</source>
        <translation>Asymptotisches Spot-Rauschen</translation>
    </message>
    <message>
        <source>Autocorrelation</source>
        <translation>Autokorrelation</translation>
    </message>
    <message>
        <source>Average</source>
        <translation>Mittelwert</translation>
    </message>
    <message>
        <source>Axes that are bent one by one; channels as they are may show false colours.</source>
        <translation>Achsen, die einzeln gebogen werden; mit den Kanälen selbst können falsche Farben entstehen.</translation>
    </message>
    <message>
        <source>Bands: orientations</source>
        <translation>Bänder: Richtungen</translation>
    </message>
    <message>
        <source>Bands: phases across scales</source>
        <translation>Bänder: Phasen über Skalen</translation>
    </message>
    <message>
        <source>Bends</source>
        <translation>Biegungen</translation>
    </message>
    <message>
        <source>Blended band</source>
        <translation>Überblendeter Streifen</translation>
    </message>
    <message>
        <source>Blender</source>
        <translation>Blender</translation>
    </message>
    <message>
        <source>Blending</source>
        <translation>Überblenden</translation>
    </message>
    <message>
        <source>Block</source>
        <translation>Block</translation>
    </message>
    <message>
        <source>Block size</source>
        <translation>Blockgröße</translation>
    </message>
    <message>
        <source>Border</source>
        <translation>Rand</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>Pinsel</translation>
    </message>
    <message>
        <source>Channels</source>
        <translation>Kanäle</translation>
    </message>
    <message>
        <source>Channels that count</source>
        <translation>Zählende Kanäle</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Colour axes</source>
        <translation>Farbachsen</translation>
    </message>
    <message>
        <source>Column of the exemplar at which the tile begins.</source>
        <translation>Spalte der Vorlage, an der die Kachel beginnt.</translation>
    </message>
    <message>
        <source>Column of the exemplar&apos;s lattice that lies at the output&apos;s left side: moves the pattern sideways.</source>
        <translation>Spalte im Gitter der Vorlage, die am linken Rand der Ausgabe liegt: verschiebt das Muster seitwärts.</translation>
    </message>
    <message>
        <source>Compared border</source>
        <translation>Verglichener Rand</translation>
    </message>
    <message>
        <source>Conditional Gaussian</source>
        <translation>Bedingte Gauß-Patches</translation>
    </message>
    <message>
        <source>Correlation</source>
        <translation>Korrelation</translation>
    </message>
    <message>
        <source>Cosine</source>
        <translation>Kosinus</translation>
    </message>
    <message>
        <source>Data (never converted)</source>
        <translation>Daten (nie umgerechnet)</translation>
    </message>
    <message>
        <source>Differences keep brightness even between blocks; correlation fits edges better where brightness differs.</source>
        <translation>Differenzen halten die Helligkeit zwischen Blöcken gleich; Korrelation passt Kanten besser an, wo die Helligkeit verschieden ist.</translation>
    </message>
    <message>
        <source>Directions told apart at each scale: more keep lines at more angles, and take longer.</source>
        <translation>Richtungen, die je Skala unterschieden werden: mehr erhalten Linien in mehr Winkeln und dauern länger.</translation>
    </message>
    <message>
        <source>Drawing phases</source>
        <translation>Phasen werden gezogen</translation>
    </message>
    <message>
        <source>Edits of exemplars</source>
        <translation>Bearbeitungen der Vorlagen</translation>
    </message>
    <message>
        <source>Estimating the synthesis map</source>
        <translation>Synthesekarte wird geschätzt</translation>
    </message>
    <message>
        <source>Even out the light</source>
        <translation>Licht ausgleichen</translation>
    </message>
    <message>
        <source>Exemplar</source>
        <translation>Vorlage</translation>
    </message>
    <message>
        <source>Exemplars</source>
        <translation>Vorlagen</translation>
    </message>
    <message>
        <source>Fading border</source>
        <translation>Auslaufender Rand</translation>
    </message>
    <message>
        <source>Filling gaps</source>
        <translation>Lücken werden gefüllt</translation>
    </message>
    <message>
        <source>Filtering</source>
        <translation>Filterung</translation>
    </message>
    <message>
        <source>Finds the lattice of a regular texture and repeats the one tile that joins itself best: strictly regular, without the variety of near-regular synthesis.</source>
        <translation>Findet das Gitter einer regelmäßigen Textur und wiederholt die eine Kachel, die am besten an sich selbst anschließt: streng regelmäßig, ohne die Vielfalt der fast regelmäßigen Synthese.</translation>
    </message>
    <message>
        <source>Finds the lattice of bricks, tiles or weave and samples blocks at random along it, then fills the gaps with patches that fit: keeps the courses and varies what lies in them.</source>
        <translation>Findet das Gitter von Ziegeln, Fliesen oder Gewebe, zieht zufällig Blöcke daraus und füllt die Lücken mit passenden Patches: erhält die Reihen und variiert, was darin liegt.</translation>
    </message>
    <message>
        <source>First vector, down</source>
        <translation>Erster Vektor, nach unten</translation>
    </message>
    <message>
        <source>First vector, right</source>
        <translation>Erster Vektor, nach rechts</translation>
    </message>
    <message>
        <source>Fit by</source>
        <translation>Anpassen nach</translation>
    </message>
    <message>
        <source>Found by itself</source>
        <translation>Selbst gefunden</translation>
    </message>
    <message>
        <source>Gaps filled</source>
        <translation>Gefüllte Lücken</translation>
    </message>
    <message>
        <source>Gaussian patches</source>
        <translation>Gauß-Patches</translation>
    </message>
    <message>
        <source>Gives noise the exemplar&apos;s histogram in every band of a steerable pyramid. Quick and free of copies; suits grainy and stochastic textures, and loses structure.</source>
        <translation>Gibt Rauschen in jedem Band einer steuerbaren Pyramide das Histogramm der Vorlage. Schnell und ohne Kopien; gut für körnige und stochastische Texturen, verliert Strukturen.</translation>
    </message>
    <message>
        <source>Gives noise the exemplar&apos;s joint statistics in a complex steerable pyramid, round after round. Never copies; suits gravel, grass, bark and other dense textures, and loses regular layouts.</source>
        <translation>Gibt Rauschen Runde für Runde die gemeinsame Statistik der Vorlage in einer komplexen steuerbaren Pyramide. Kopiert nie; gut für Kies, Gras, Rinde und andere dichte Texturen, verliert regelmäßige Anordnungen.</translation>
    </message>
    <message>
        <source>Godot</source>
        <translation>Godot</translation>
    </message>
    <message>
        <source>Heeger–Bergen</source>
        <translation>Heeger–Bergen</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>How a patch joins its neighbours: along the cut of least error, or blended over the overlap.</source>
        <translation>Wie ein Patch an seine Nachbarn anschließt: entlang des Schnitts mit dem kleinsten Fehler oder über die Überlappung geblendet.</translation>
    </message>
    <message>
        <source>How far down the texture repeats itself first.</source>
        <translation>Wie weit nach unten sich die Textur zuerst wiederholt.</translation>
    </message>
    <message>
        <source>How far down the texture repeats itself in the other direction.</source>
        <translation>Wie weit nach unten sich die Textur in der anderen Richtung wiederholt.</translation>
    </message>
    <message>
        <source>How far from the lattice a patch that fills a gap may lie: more joins better where the texture is irregular, less keeps the courses straight.</source>
        <translation>Wie weit vom Gitter ein Patch liegen darf, der eine Lücke füllt: mehr schließt in unregelmäßigen Texturen besser an, weniger hält die Reihen gerade.</translation>
    </message>
    <message>
        <source>How far shared pixels may vary, in per cent of the exemplar&apos;s standard deviation.</source>
        <translation>Wie stark geteilte Pixel abweichen dürfen, in Prozent der Standardabweichung der Vorlage.</translation>
    </message>
    <message>
        <source>How far the smoothed cut blends to either side.</source>
        <translation>Wie weit der geglättete Schnitt nach beiden Seiten überblendet.</translation>
    </message>
    <message>
        <source>How far to the right the texture repeats itself first.</source>
        <translation>Wie weit nach rechts sich die Textur zuerst wiederholt.</translation>
    </message>
    <message>
        <source>How far to the right the texture repeats itself in the other direction.</source>
        <translation>Wie weit nach rechts sich die Textur in der anderen Richtung wiederholt.</translation>
    </message>
    <message>
        <source>How many of the first channels are synthesised jointly, 0 for all; the others follow them point by point and have no say.</source>
        <translation>Wie viele der ersten Kanäle gemeinsam erzeugt werden, 0 für alle; die übrigen folgen ihnen Punkt für Punkt und zählen nicht mit.</translation>
    </message>
    <message>
        <source>How much worse than the best a patch may fit and still be drawn: larger varies more, smaller copies longer stretches.</source>
        <translation>Wie viel schlechter als der beste ein Patch passen darf, um noch gezogen zu werden: größer variiert mehr, kleiner kopiert längere Stücke.</translation>
    </message>
    <message>
        <source>How much worse than the best a patch may fit and still be drawn: larger varies more.</source>
        <translation>Wie viel schlechter als der beste ein Patch passen darf, um noch gezogen zu werden: größer variiert mehr.</translation>
    </message>
    <message>
        <source>How often the exemplar is halved, plus one: more keep larger structures.</source>
        <translation>Wie oft die Vorlage halbiert wird, plus eins: mehr erhalten größere Strukturen.</translation>
    </message>
    <message>
        <source>How phases line up from one scale to the next: lit edges against shaded ones.</source>
        <translation>Wie Phasen von einer Skala zur nächsten zueinander stehen: beleuchtete gegen beschattete Kanten.</translation>
    </message>
    <message>
        <source>How pixels and blurred images repeat within the neighbourhood.</source>
        <translation>Wie sich Pixel und weichgezeichnete Bilder innerhalb der Nachbarschaft wiederholen.</translation>
    </message>
    <message>
        <source>How strong lines of one angle and size come in groups.</source>
        <translation>Wie stark Linien eines Winkels und einer Größe in Gruppen auftreten.</translation>
    </message>
    <message>
        <source>How the bands of one scale go together in sign, across angles and channels.</source>
        <translation>Wie die Bänder einer Skala im Vorzeichen zusammengehen, über Winkel und Kanäle.</translation>
    </message>
    <message>
        <source>Image quilting</source>
        <translation>Bild-Quilting</translation>
    </message>
    <message>
        <source>Imposing statistics</source>
        <translation>Statistiken werden aufgeprägt</translation>
    </message>
    <message>
        <source>Innovation</source>
        <translation>Neuheit</translation>
    </message>
    <message>
        <source>Innovation, estimated</source>
        <translation>Neuheit, geschätzt</translation>
    </message>
    <message>
        <source>Iterations</source>
        <translation>Durchläufe</translation>
    </message>
    <message>
        <source>Join</source>
        <translation>Anschluss</translation>
    </message>
    <message>
        <source>Kept (CLG)</source>
        <translation>Beibehalten (CLG)</translation>
    </message>
    <message>
        <source>Lattice</source>
        <translation>Gitter</translation>
    </message>
    <message>
        <source>Lattice, first vector down</source>
        <translation>Gitter, erster Vektor nach unten</translation>
    </message>
    <message>
        <source>Lattice, first vector right</source>
        <translation>Gitter, erster Vektor nach rechts</translation>
    </message>
    <message>
        <source>Lattice, second vector down</source>
        <translation>Gitter, zweiter Vektor nach unten</translation>
    </message>
    <message>
        <source>Lattice, second vector right</source>
        <translation>Gitter, zweiter Vektor nach rechts</translation>
    </message>
    <message>
        <source>Lays out large structures at a coarse scale and adds new detail at each finer one. Keeps the layout of macro-textures with small patches; softer than quilting.</source>
        <translation>Legt große Strukturen auf grober Skala an und fügt auf jeder feineren neue Einzelheiten hinzu. Hält die Anordnung von Makrotexturen mit kleinen Patches; weicher als Quilting.</translation>
    </message>
    <message>
        <source>Learns from the exemplar&apos;s periodic component, without which its borders count as horizontal and vertical lines.</source>
        <translation>Lernt aus dem periodischen Anteil der Vorlage; ohne ihn zählen deren Ränder als waagrechte und senkrechte Linien.</translation>
    </message>
    <message>
        <source>Learns from the exemplar&apos;s periodic component, without which its borders draw horizontal and vertical streaks.</source>
        <translation>Lernt aus dem periodischen Anteil der Vorlage; ohne ihn ziehen deren Ränder waagrechte und senkrechte Streifen.</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Licht</translation>
    </message>
    <message>
        <source>Like quilting, but every patch is new: a random blend of the exemplar patches that fit best. Innovates where quilting copies; a little softer.</source>
        <translation>Wie Quilting, aber jeder Patch ist neu: eine zufällige Mischung der am besten passenden Patches. Erfindet, wo Quilting kopiert; etwas weicher.</translation>
    </message>
    <message>
        <source>Linear</source>
        <translation>Linear</translation>
    </message>
    <message>
        <source>Linear Rec.709</source>
        <translation>Lineares Rec.709</translation>
    </message>
    <message>
        <source>Linear blending</source>
        <translation>Lineares Überblenden</translation>
    </message>
    <message>
        <source>Locally Gaussian</source>
        <translation>Lokal gaußsch</translation>
    </message>
    <message>
        <source>Locally Gaussian + Portilla–Simoncelli</source>
        <translation>Lokal gaußsch + Portilla–Simoncelli</translation>
    </message>
    <message>
        <source>Locally Gaussian + Quilting</source>
        <translation>Lokal gaußsch + Quilting</translation>
    </message>
    <message>
        <source>Looking for the lattice</source>
        <translation>Gitter wird gesucht</translation>
    </message>
    <message>
        <source>Looking for the tile</source>
        <translation>Kachel wird gesucht</translation>
    </message>
    <message>
        <source>Magnitudes: autocorrelation</source>
        <translation>Beträge: Autokorrelation</translation>
    </message>
    <message>
        <source>Magnitudes: orientations</source>
        <translation>Beträge: Richtungen</translation>
    </message>
    <message>
        <source>Magnitudes: scales</source>
        <translation>Beträge: Skalen</translation>
    </message>
    <message>
        <source>Marginals</source>
        <translation>Randverteilungen</translation>
    </message>
    <message>
        <source>Matching histograms</source>
        <translation>Histogramme werden angeglichen</translation>
    </message>
    <message>
        <source>Mean error along a cut</source>
        <translation>Mittlerer Fehler entlang eines Schnitts</translation>
    </message>
    <message>
        <source>Mean squared difference where tiles join</source>
        <translation>Mittlere quadratische Differenz an den Kachelstößen</translation>
    </message>
    <message>
        <source>Mean, variance, skewness, kurtosis and range of the pixels and of blurred images.</source>
        <translation>Mittelwert, Varianz, Schiefe, Wölbung und Wertebereich der Pixel und weichgezeichneter Bilder.</translation>
    </message>
    <message>
        <source>Measuring the exemplar</source>
        <translation>Vorlage wird vermessen</translation>
    </message>
    <message>
        <source>Measuring the result</source>
        <translation>Ergebnis wird vermessen</translation>
    </message>
    <message>
        <source>Metallic</source>
        <translation>Metallisch</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>Midway</source>
        <translation>Midway</translation>
    </message>
    <message>
        <source>Midway quilting</source>
        <translation>Midway-Quilting</translation>
    </message>
    <message>
        <source>Minimum-error cut</source>
        <translation>Schnitt mit kleinstem Fehler</translation>
    </message>
    <message>
        <source>Mismatch of the pixels&apos; histogram</source>
        <translation>Abweichung des Pixelhistogramms</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>Momentum</source>
        <translation>Schwung</translation>
    </message>
    <message>
        <source>Multiscale Gaussian</source>
        <translation>Mehrskalig gaußsch</translation>
    </message>
    <message>
        <source>Multiscale Gaussian + Portilla–Simoncelli</source>
        <translation>Mehrskalig gaußsch + Portilla–Simoncelli</translation>
    </message>
    <message>
        <source>Near-regular texture</source>
        <translation>Fast regelmäßige Textur</translation>
    </message>
    <message>
        <source>Neighbourhood</source>
        <translation>Nachbarschaft</translation>
    </message>
    <message>
        <source>Neighbours</source>
        <translation>Nachbarn</translation>
    </message>
    <message>
        <source>New patches from the locally Gaussian model, then pieces of the exemplar quilted over them: keeps the model&apos;s variety and gets the exemplar&apos;s sharpness back.</source>
        <translation>Neue Patches aus dem lokal gaußschen Modell, dann Stücke der Vorlage darübergefügt: behält die Vielfalt des Modells und holt die Schärfe der Vorlage zurück.</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Normal, green down (DirectX)</source>
        <translation>Normalen, Grün nach unten (DirectX)</translation>
    </message>
    <message>
        <source>Normal, green up (OpenGL)</source>
        <translation>Normalen, Grün nach oben (OpenGL)</translation>
    </message>
    <message>
        <source>Octaves that the pyramid takes apart: more keep larger features. Small images use fewer.</source>
        <translation>Oktaven, in die die Pyramide zerlegt: mehr erhalten größere Merkmale. Kleine Bilder nutzen weniger.</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source>Orientations</source>
        <translation>Richtungen</translation>
    </message>
    <message>
        <source>Origin, down</source>
        <translation>Ursprung, nach unten</translation>
    </message>
    <message>
        <source>Origin, right</source>
        <translation>Ursprung, nach rechts</translation>
    </message>
    <message>
        <source>Other data</source>
        <translation>Andere Daten</translation>
    </message>
    <message>
        <source>Overlap</source>
        <translation>Überlappung</translation>
    </message>
    <message>
        <source>Overlap values</source>
        <translation>Werte der Überlappung</translation>
    </message>
    <message>
        <source>Patch drawn</source>
        <translation>Gezogener Patch</translation>
    </message>
    <message>
        <source>Patch size</source>
        <translation>Patchgröße</translation>
    </message>
    <message>
        <source>Patches</source>
        <translation>Patches</translation>
    </message>
    <message>
        <source>Pixels shared with neighbours stay as they are, or vary a little before the rest is drawn.</source>
        <translation>Mit Nachbarn geteilte Pixel bleiben, wie sie sind, oder schwanken ein wenig, bevor der Rest gezogen wird.</translation>
    </message>
    <message>
        <source>Placing patches</source>
        <translation>Patches werden gesetzt</translation>
    </message>
    <message>
        <source>Poisson</source>
        <translation>Poisson</translation>
    </message>
    <message>
        <source>Portilla–Simoncelli</source>
        <translation>Portilla–Simoncelli</translation>
    </message>
    <message>
        <source>Preparing the exemplar</source>
        <translation>Vorlage wird vorbereitet</translation>
    </message>
    <message>
        <source>Principal axes</source>
        <translation>Hauptachsen</translation>
    </message>
    <message>
        <source>Progressive</source>
        <translation>Fortschreitend</translation>
    </message>
    <message>
        <source>Propagation</source>
        <translation>Ausbreitung</translation>
    </message>
    <message>
        <source>Quilting that bends patches to meet instead of cutting them: structures such as stripes are drawn together along the overlap.</source>
        <translation>Quilting, das Patches zueinander biegt, statt sie zu schneiden: Strukturen wie Streifen werden über die Überlappung zusammengeführt.</translation>
    </message>
    <message>
        <source>Random phase</source>
        <translation>Zufallsphase</translation>
    </message>
    <message>
        <source>Random phase noise</source>
        <translation>Zufallsphasen-Rauschen</translation>
    </message>
    <message>
        <source>Random phase noise keeps each frequency&apos;s strength exactly; spot noise lets it vary as in a Gaussian field.</source>
        <translation>Zufallsphasen-Rauschen hält die Stärke jeder Frequenz genau; Spot-Rauschen lässt sie schwanken wie in einem Gauß-Feld.</translation>
    </message>
    <message>
        <source>Regular tile</source>
        <translation>Regelmäßige Kachel</translation>
    </message>
    <message>
        <source>Regularisation</source>
        <translation>Regularisierung</translation>
    </message>
    <message>
        <source>Relaxation</source>
        <translation>Lockerung</translation>
    </message>
    <message>
        <source>Relaxed (RCLG)</source>
        <translation>Gelockert (RCLG)</translation>
    </message>
    <message>
        <source>Repeating the tile</source>
        <translation>Kachel wird wiederholt</translation>
    </message>
    <message>
        <source>Replacing patches</source>
        <translation>Patches werden ersetzt</translation>
    </message>
    <message>
        <source>Roughness</source>
        <translation>Rauheit</translation>
    </message>
    <message>
        <source>Rounds between pyramid and pixels: more bring both closer to the exemplar.</source>
        <translation>Durchgänge zwischen Pyramide und Pixeln: mehr bringen beide der Vorlage näher.</translation>
    </message>
    <message>
        <source>Rounds over all statistics: more bring them closer to the exemplar&apos;s.</source>
        <translation>Durchgänge über alle Statistiken: mehr bringen sie denen der Vorlage näher.</translation>
    </message>
    <message>
        <source>Row of the exemplar at which the tile begins.</source>
        <translation>Zeile der Vorlage, an der die Kachel beginnt.</translation>
    </message>
    <message>
        <source>Row of the exemplar&apos;s lattice that lies at the output&apos;s top: moves the pattern up or down.</source>
        <translation>Zeile im Gitter der Vorlage, die am oberen Rand der Ausgabe liegt: verschiebt das Muster nach oben oder unten.</translation>
    </message>
    <message>
        <source>Sampling blocks</source>
        <translation>Blöcke werden gezogen</translation>
    </message>
    <message>
        <source>Sampling patches</source>
        <translation>Patches werden gezogen</translation>
    </message>
    <message>
        <source>Sampling scale {} of {}</source>
        <translation>Skala {} von {} wird gezogen</translation>
    </message>
    <message>
        <source>Scales</source>
        <translation>Skalen</translation>
    </message>
    <message>
        <source>Scales used</source>
        <translation>Benutzte Skalen</translation>
    </message>
    <message>
        <source>Seam, left to right</source>
        <translation>Naht, links/rechts</translation>
    </message>
    <message>
        <source>Seam, top to bottom</source>
        <translation>Naht, oben/unten</translation>
    </message>
    <message>
        <source>Second vector, down</source>
        <translation>Zweiter Vektor, nach unten</translation>
    </message>
    <message>
        <source>Second vector, right</source>
        <translation>Zweiter Vektor, nach rechts</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Startwert</translation>
    </message>
    <message>
        <source>Sews square patches of the exemplar together along the cuts where they differ least. Fast and faithful to structure such as bricks or leaves; copies larger areas verbatim.</source>
        <translation>Fügt quadratische Patches der Vorlage entlang der Schnitte zusammen, an denen sie sich am wenigsten unterscheiden. Schnell und treu bei Strukturen wie Ziegeln oder Blättern; kopiert größere Flächen wörtlich.</translation>
    </message>
    <message>
        <source>Share of each round&apos;s change that is added once more: some brings the statistics closer in fewer rounds.</source>
        <translation>Anteil der Änderung jedes Durchgangs, der noch einmal hinzukommt: etwas davon bringt die Statistiken in weniger Durchgängen näher.</translation>
    </message>
    <message>
        <source>Share of each side over which the exemplar fades out where the output has another size: larger leaves fewer streaks, smaller keeps slow changes.</source>
        <translation>Anteil jeder Seite, über den die Vorlage ausläuft, wo die Ausgabe eine andere Größe hat: größer lässt weniger Streifen, kleiner erhält langsame Änderungen.</translation>
    </message>
    <message>
        <source>Share of the patch over which it fades into its neighbours.</source>
        <translation>Anteil des Patches, über den er in seine Nachbarn übergeht.</translation>
    </message>
    <message>
        <source>Share of the patch that is given by its neighbours: larger fits better and takes longer.</source>
        <translation>Anteil des Patches, den seine Nachbarn vorgeben: größer passt besser und dauert länger.</translation>
    </message>
    <message>
        <source>Share of the patch that overlaps its neighbours: larger bends more gently.</source>
        <translation>Anteil des Patches, der seine Nachbarn überlappt: größer biegt sanfter.</translation>
    </message>
    <message>
        <source>Share of the patch that overlaps its neighbours: larger fits better and takes longer.</source>
        <translation>Anteil des Patches, der seine Nachbarn überlappt: größer passt besser und dauert länger.</translation>
    </message>
    <message>
        <source>Share of the patch that overlaps its neighbours: larger joins better, but repeats itself sooner.</source>
        <translation>Anteil des Patches, der seine Nachbarn überlappt: größer schließt besser an, wiederholt sich aber eher.</translation>
    </message>
    <message>
        <source>Side of the patches at every scale: at the coarsest one they cover 2 to the power of scales − 1 times as much.</source>
        <translation>Seite der Patches auf jeder Skala: Auf der gröbsten überdecken sie 2 hoch (Skalen − 1) mal so viel.</translation>
    </message>
    <message>
        <source>Side of the patches that are replaced: larger changes larger parts at once.</source>
        <translation>Seite der Patches, die ersetzt werden: größer ändert größere Teile auf einmal.</translation>
    </message>
    <message>
        <source>Side of the patches: larger keeps larger structures whole, smaller finds more that are alike.</source>
        <translation>Seite der Patches: größer hält größere Strukturen ganz, kleiner findet mehr ähnliche.</translation>
    </message>
    <message>
        <source>Side of the square in which pixels and magnitudes are compared at each scale: larger keeps larger patterns, but copies chance ones.</source>
        <translation>Seite des Quadrats, in dem Pixel und Beträge je Skala verglichen werden: größer erhält größere Muster, kopiert aber auch zufällige.</translation>
    </message>
    <message>
        <source>Side of the squares that are copied: larger keeps larger structures whole, smaller varies more.</source>
        <translation>Seite der Quadrate, die kopiert werden: größer hält größere Strukturen ganz, kleiner variiert mehr.</translation>
    </message>
    <message>
        <source>Similar patches that a Gaussian is learnt from: more join more smoothly and blur more.</source>
        <translation>Ähnliche Patches, aus denen eine Gauß-Verteilung gelernt wird: mehr schließen glatter an und verwischen mehr.</translation>
    </message>
    <message>
        <source>Similar patches that each new one is blended from: more vary more and blur more.</source>
        <translation>Ähnliche Patches, aus denen jeder neue gemischt wird: mehr variieren mehr und verwischen mehr.</translation>
    </message>
    <message>
        <source>Similar patches that each new one is blended from: more vary more and blur more; 1 copies.</source>
        <translation>Ähnliche Patches, aus denen jeder neue gemischt wird: mehr variieren mehr und verwischen mehr; 1 kopiert.</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Smoothed cut</source>
        <translation>Geglätteter Schnitt</translation>
    </message>
    <message>
        <source>Soft changes</source>
        <translation>Weiche Verläufe</translation>
    </message>
    <message>
        <source>Softness</source>
        <translation>Weichheit</translation>
    </message>
    <message>
        <source>Squared differences</source>
        <translation>Quadrierte Differenzen</translation>
    </message>
    <message>
        <source>Start from</source>
        <translation>Beginnen mit</translation>
    </message>
    <message>
        <source>Starting</source>
        <translation>Beginnt</translation>
    </message>
    <message>
        <source>Statistics</source>
        <translation>Statistiken</translation>
    </message>
    <message>
        <source>Stitch</source>
        <translation>Naht</translation>
    </message>
    <message>
        <source>Straighten</source>
        <translation>Begradigen</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Stärke</translation>
    </message>
    <message>
        <source>Take off border jumps</source>
        <translation>Randsprünge entfernen</translation>
    </message>
    <message>
        <source>Takes slow changes of brightness out of the exemplar first, so that blocks from its light and dark parts match; pixels change a little.</source>
        <translation>Nimmt zuerst langsame Helligkeitsänderungen aus der Vorlage, damit Blöcke aus hellen und dunklen Teilen zusammenpassen; Pixel ändern sich ein wenig.</translation>
    </message>
    <message>
        <source>The large structures of the multiscale Gaussian model, sharpened by Portilla–Simoncelli.</source>
        <translation>Die großen Strukturen des mehrskaligen Gauß-Modells, geschärft durch Portilla–Simoncelli.</translation>
    </message>
    <message>
        <source>The layout of the locally Gaussian model with the grain of Portilla–Simoncelli: nothing is copied, and where the model went astray it is drawn back.</source>
        <translation>Die Anordnung des lokal gaußschen Modells mit dem Korn von Portilla–Simoncelli: Nichts wird kopiert, und wo das Modell abirrte, wird es zurückgeholt.</translation>
    </message>
    <message>
        <source>The most probable</source>
        <translation>Der wahrscheinlichste</translation>
    </message>
    <message>
        <source>The most probable patch joins most smoothly and loses detail; samples differ each time.</source>
        <translation>Der wahrscheinlichste Patch schließt am glattesten an und verliert Einzelheiten; Stichproben sind jedes Mal anders.</translation>
    </message>
    <message>
        <source>The one that joins itself best</source>
        <translation>Die am besten an sich selbst anschließt</translation>
    </message>
    <message>
        <source>The tile that is repeated: the one whose opposite sides are most alike, or the one at a given place.</source>
        <translation>Die Kachel, die wiederholt wird: die mit den ähnlichsten gegenüberliegenden Seiten oder die an einer angegebenen Stelle.</translation>
    </message>
    <message>
        <source>The two vectors by which the texture repeats itself: found in the exemplar, given, or none for a texture that does not repeat.</source>
        <translation>Die zwei Vektoren, um die sich die Textur wiederholt: in der Vorlage gefunden, angegeben oder keine für eine Textur ohne Wiederholung.</translation>
    </message>
    <message>
        <source>Then</source>
        <translation>Dann</translation>
    </message>
    <message>
        <source>Tile</source>
        <translation>Kachel</translation>
    </message>
    <message>
        <source>Tile&apos;s corner, down</source>
        <translation>Ecke der Kachel, nach unten</translation>
    </message>
    <message>
        <source>Tile&apos;s corner, right</source>
        <translation>Ecke der Kachel, nach rechts</translation>
    </message>
    <message>
        <source>Tile, first vector down</source>
        <translation>Kachel, erster Vektor nach unten</translation>
    </message>
    <message>
        <source>Tile, first vector right</source>
        <translation>Kachel, erster Vektor nach rechts</translation>
    </message>
    <message>
        <source>Tile, second vector down</source>
        <translation>Kachel, zweiter Vektor nach unten</translation>
    </message>
    <message>
        <source>Tile, second vector right</source>
        <translation>Kachel, zweiter Vektor nach rechts</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>Turns and shears the exemplar so that its courses run along the axes in whole pixels; pixels are interpolated.</source>
        <translation>Dreht und schert die Vorlage, sodass ihre Reihen in ganzen Pixeln an den Achsen liegen; Pixel werden interpoliert.</translation>
    </message>
    <message>
        <source>Unity (mask map)</source>
        <translation>Unity (Mask Map)</translation>
    </message>
    <message>
        <source>Unreal Engine</source>
        <translation>Unreal Engine</translation>
    </message>
    <message>
        <source>Weight of the second exemplar</source>
        <translation>Gewicht der zweiten Vorlage</translation>
    </message>
    <message>
        <source>Whether channels are synthesised jointly; without, each principal component is by itself.</source>
        <translation>Ob Kanäle gemeinsam erzeugt werden; sonst steht jede Hauptkomponente für sich.</translation>
    </message>
    <message>
        <source>Whether the bending fades out over the overlap, or lines pass into each other.</source>
        <translation>Ob das Biegen über die Überlappung ausläuft oder Linien ineinander übergehen.</translation>
    </message>
    <message>
        <source>Which angles come together: corners and crossings.</source>
        <translation>Welche Winkel zusammen auftreten: Ecken und Kreuzungen.</translation>
    </message>
    <message>
        <source>Which sizes come together: edges against thin lines.</source>
        <translation>Welche Größen zusammen auftreten: Kanten gegen dünne Linien.</translation>
    </message>
    <message>
        <source>White noise added to the model, in per cent of the exemplar&apos;s standard deviation: more lets patches fit their neighbours less.</source>
        <translation>Weißes Rauschen, das dem Modell hinzugefügt wird, in Prozent der Standardabweichung der Vorlage: mehr lässt Patches weniger zu ihren Nachbarn passen.</translation>
    </message>
    <message>
        <source>Width in which a patch is compared with, and joined to, its neighbours; 0 takes a share of the block.</source>
        <translation>Breite, in der ein Patch mit seinen Nachbarn verglichen und verbunden wird; 0 nimmt einen Anteil des Blocks.</translation>
    </message>
    <message>
        <source>Width of the band that is blended: wider hides differences of brightness between blocks, narrower is sharper.</source>
        <translation>Breite des überblendeten Streifens: breiter verbirgt Helligkeitsunterschiede zwischen Blöcken, schmaler ist schärfer.</translation>
    </message>
    <message>
        <source>Width of the borders in which opposite sides of a tile are compared: wider looks for tiles that join in larger structures.</source>
        <translation>Breite der Ränder, in denen gegenüberliegende Seiten einer Kachel verglichen werden: breiter sucht Kacheln, die in größeren Strukturen anschließen.</translation>
    </message>
    <message>
        <source>Wraps</source>
        <translation>Kachelbar</translation>
    </message>
    <message>
        <source>glTF</source>
        <translation>glTF</translation>
    </message>
    <message>
        <source>packed companion maps</source>
        <translation>gepackte Begleitkarten</translation>
    </message>
    <message>
        <source>sRGB</source>
        <translation>sRGB</translation>
    </message>
    <message>
        <source>Comparing colours</source>
        <translation>Farben werden verglichen</translation>
    </message>
    <message>
        <source>Comparing patches</source>
        <translation>Patches werden verglichen</translation>
    </message>
    <message>
        <source>Comparing with itself</source>
        <translation>Vergleich mit sich selbst</translation>
    </message>
    <message>
        <source>Estimating the map</source>
        <translation>Karte wird geschätzt</translation>
    </message>
    <message>
        <source>Laying out the band</source>
        <translation>Streifen wird ausgelegt</translation>
    </message>
    <message>
        <source>Aggregation</source>
        <translation>Zusammenfassung</translation>
    </message>
    <message>
        <source>Avoids colours that there are too many of already, so that all colours of the exemplar show.</source>
        <translation>Meidet Farben, von denen es schon zu viele gibt, sodass alle Farben der Vorlage vorkommen.</translation>
    </message>
    <message>
        <source>Blend</source>
        <translation>Überblenden</translation>
    </message>
    <message>
        <source>Bootstrap</source>
        <translation>Bootstrap</translation>
    </message>
    <message>
        <source>Both directions</source>
        <translation>Beide Richtungen</translation>
    </message>
    <message>
        <source>Changes the whole output until all its patches are like patches of the exemplar, from coarse to fine and with ever smaller patches. Smooth joins and good large structure; may simplify what is irregular.</source>
        <translation>Ändert die ganze Ausgabe, bis alle ihre Patches Patches der Vorlage gleichen, von grob nach fein und mit immer kleineren Patches. Glatte Anschlüsse und gute große Struktur; kann Unregelmäßiges vereinfachen.</translation>
    </message>
    <message>
        <source>Coarse iterations</source>
        <translation>Grobe Durchläufe</translation>
    </message>
    <message>
        <source>Colour histograms apart</source>
        <translation>Abstand der Farbhistogramme</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Copying pixels</source>
        <translation>Pixel werden kopiert</translation>
    </message>
    <message>
        <source>Douglas–Rachford</source>
        <translation>Douglas–Rachford</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Verdoppeln</translation>
    </message>
    <message>
        <source>Energy of a patch</source>
        <translation>Energie eines Patches</translation>
    </message>
    <message>
        <source>Every patch of the exemplar looks for its place in the output, too, so that less gets lost.</source>
        <translation>Jeder Patch der Vorlage sucht auch seinen Platz in der Ausgabe, sodass weniger verloren geht.</translation>
    </message>
    <message>
        <source>Exact</source>
        <translation>Genau</translation>
    </message>
    <message>
        <source>Fine iterations</source>
        <translation>Feine Durchläufe</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>Abschluss</translation>
    </message>
    <message>
        <source>For outputs of another size than the exemplar&apos;s: all patches equally often, or patches drawn at random.</source>
        <translation>Für Ausgaben anderer Größe als die Vorlage: alle Patches gleich oft oder zufällig gezogene Patches.</translation>
    </message>
    <message>
        <source>Forward share</source>
        <translation>Vorwärtsanteil</translation>
    </message>
    <message>
        <source>Geometric median</source>
        <translation>Geometrischer Median</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Raster</translation>
    </message>
    <message>
        <source>How much a patch that is used too often is avoided: larger shows all of the exemplar, 0 takes whatever fits best.</source>
        <translation>Wie sehr ein zu oft benutzter Patch gemieden wird: größer zeigt die ganze Vorlage, 0 nimmt, was am besten passt.</translation>
    </message>
    <message>
        <source>How much the output&apos;s patches count against the exemplar&apos;s: larger joins better, smaller loses less.</source>
        <translation>Wie viel die Patches der Ausgabe gegenüber denen der Vorlage zählen: größer schließt besser an, kleiner verliert weniger.</translation>
    </message>
    <message>
        <source>How much worse than the best an assignment may be for each patch: 0 for the best, 1 or 2 is faster and looks as good.</source>
        <translation>Wie viel schlechter als die beste eine Zuordnung je Patch sein darf: 0 für die beste, 1 oder 2 ist schneller und sieht ebenso gut aus.</translation>
    </message>
    <message>
        <source>How overlapping patches are joined: the mean (r = 2) blurs, robust weights (r = 0.8) and the geometric median stay sharp.</source>
        <translation>Wie überlappende Patches verbunden werden: Der Mittelwert (r = 2) verwischt, robuste Gewichte (r = 0,8) und der geometrische Median bleiben scharf.</translation>
    </message>
    <message>
        <source>How the geometric median of overlapping patches is found; the result is the same to four digits.</source>
        <translation>Wie der geometrische Median überlappender Patches gefunden wird; das Ergebnis ist auf vier Stellen dasselbe.</translation>
    </message>
    <message>
        <source>Hybrid</source>
        <translation>Gemischt</translation>
    </message>
    <message>
        <source>Judging the result</source>
        <translation>Ergebnis wird beurteilt</translation>
    </message>
    <message>
        <source>Keeps the joined patches, or copies for each pixel the exemplar&apos;s nearest to it: sharper, with an exact map.</source>
        <translation>Behält die verbundenen Patches oder kopiert für jedes Pixel das nächste der Vorlage: schärfer, mit genauer Karte.</translation>
    </message>
    <message>
        <source>Largest patch</source>
        <translation>Größter Patch</translation>
    </message>
    <message>
        <source>Largest verbatim region, %</source>
        <translation>Größtes wörtliches Gebiet, %</translation>
    </message>
    <message>
        <source>Lets overlapping patches of the output find similar ones in the exemplar, from coarse to fine, and copies the pixels that most of them agree on. Very fast, at its best on textures without large structure.</source>
        <translation>Lässt überlappende Patches der Ausgabe ähnliche in der Vorlage finden, von grob nach fein, und kopiert die Pixel, auf die sich die meisten einigen. Sehr schnell, am besten bei Texturen ohne große Struktur.</translation>
    </message>
    <message>
        <source>Lets patches be used more or less often, so that what fits nowhere may be left out.</source>
        <translation>Erlaubt, Patches öfter oder seltener zu benutzen, sodass wegbleiben kann, was nirgends passt.</translation>
    </message>
    <message>
        <source>Match colours</source>
        <translation>Farben angleichen</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Mittelwert</translation>
    </message>
    <message>
        <source>Mean cost of a patch</source>
        <translation>Mittlere Kosten eines Patches</translation>
    </message>
    <message>
        <source>Mean distance of the patches</source>
        <translation>Mittlerer Abstand der Patches</translation>
    </message>
    <message>
        <source>Median</source>
        <translation>Median</translation>
    </message>
    <message>
        <source>Occurrence</source>
        <translation>Häufigkeit</translation>
    </message>
    <message>
        <source>Patch assignment</source>
        <translation>Patch-Zuordnung</translation>
    </message>
    <message>
        <source>Patch-occurrence entropy</source>
        <translation>Entropie der Patch-Häufigkeit</translation>
    </message>
    <message>
        <source>PatchMatch</source>
        <translation>PatchMatch</translation>
    </message>
    <message>
        <source>Patches apart, first principal axis</source>
        <translation>Abstand der Patches, erste Hauptachse</translation>
    </message>
    <message>
        <source>Patches apart, second principal axis</source>
        <translation>Abstand der Patches, zweite Hauptachse</translation>
    </message>
    <message>
        <source>Patches apart, sliced Wasserstein</source>
        <translation>Abstand der Patches, Sliced Wasserstein</translation>
    </message>
    <message>
        <source>Patches apart, sliced Wasserstein at half scale</source>
        <translation>Abstand der Patches, Sliced Wasserstein, halbe Skala</translation>
    </message>
    <message>
        <source>Patches apart, sliced Wasserstein at quarter scale</source>
        <translation>Abstand der Patches, Sliced Wasserstein, Viertelskala</translation>
    </message>
    <message>
        <source>Patches shrink from this size to 8 px by halves: larger ones keep larger structures whole.</source>
        <translation>Patches schrumpfen von dieser Größe durch Halbieren auf 8 px: größere halten größere Strukturen ganz.</translation>
    </message>
    <message>
        <source>Random</source>
        <translation>Zufällig</translation>
    </message>
    <message>
        <source>Regular</source>
        <translation>Regelmäßig</translation>
    </message>
    <message>
        <source>Relaxed</source>
        <translation>Gelockert</translation>
    </message>
    <message>
        <source>Robust</source>
        <translation>Robust</translation>
    </message>
    <message>
        <source>Robust, Gaussian falloff</source>
        <translation>Robust, gaußscher Abfall</translation>
    </message>
    <message>
        <source>Rounds of matching and voting on each scale: more join better, but take longer.</source>
        <translation>Durchgänge aus Suchen und Abstimmen je Skala: mehr schließen besser an, dauern aber länger.</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suche</translation>
    </message>
    <message>
        <source>Side of the patches, which lie a quarter of it apart: larger keeps larger structures, smaller varies more.</source>
        <translation>Seite der Patches, die ein Viertel davon auseinanderliegen: größer erhält größere Strukturen, kleiner variiert mehr.</translation>
    </message>
    <message>
        <source>Supply</source>
        <translation>Vorrat</translation>
    </message>
    <message>
        <source>Texture optimisation</source>
        <translation>Texturoptimierung</translation>
    </message>
    <message>
        <source>Tracing the pixels</source>
        <translation>Pixel werden verfolgt</translation>
    </message>
    <message>
        <source>Uniformity</source>
        <translation>Gleichmäßigkeit</translation>
    </message>
    <message>
        <source>Uses every patch of the exemplar as often as every other, so that nothing gets lost and nothing takes over. Keeps the exemplar&apos;s mix of colours and details; slow for large outputs.</source>
        <translation>Benutzt jeden Patch der Vorlage so oft wie jeden anderen, sodass nichts verloren geht und nichts überhandnimmt. Erhält die Mischung von Farben und Einzelheiten; langsam bei großen Ausgaben.</translation>
    </message>
    <message>
        <source>Weiszfeld</source>
        <translation>Weiszfeld</translation>
    </message>
    <message>
        <source>What each use too many or too few costs: 0 takes the nearest patches, a large value uses all alike.</source>
        <translation>Was jede Benutzung zu viel oder zu wenig kostet: 0 nimmt die nächsten Patches, ein großer Wert benutzt alle gleich.</translation>
    </message>
    <message>
        <source>Where the exemplar&apos;s patches lie: a regular grid is sharp and copies larger pieces, a random one varies more and blurs, the hybrid is random but on the finest scale.</source>
        <translation>Wo die Patches der Vorlage liegen: Ein regelmäßiges Raster ist scharf und kopiert größere Stücke, ein zufälliges variiert mehr und verwischt, das gemischte ist zufällig außer auf der feinsten Skala.</translation>
    </message>
    <message>
        <source>Always</source>
        <translation>Immer</translation>
    </message>
    <message>
        <source>Never</source>
        <translation>Nie</translation>
    </message>
    <message>
        <source>Where patches would show</source>
        <translation>Wo Flicken sichtbar würden</translation>
    </message>
    <message>
        <source>Coarsest stitch</source>
        <translation>Gröbste Naht</translation>
    </message>
    <message>
        <source>Contrast</source>
        <translation>Kontrast</translation>
    </message>
    <message>
        <source>How far flat patches are kept from winning where nothing fits well: 1 holds the exemplar&apos;s contrast; 0 compares as published, and outputs may fade.</source>
        <translation>Wie weit flaue Patches davon abgehalten werden zu gewinnen, wo nichts gut passt: 1 hält den Kontrast der Vorlage; 0 vergleicht wie veröffentlicht, und Ergebnisse können verflachen.</translation>
    </message>
    <message>
        <source>How patches join at all scales but the coarsest: along the cut of least error, blended, or pasted, as published.</source>
        <translation>Wie Patches auf allen Skalen außer der gröbsten aneinander anschließen: entlang des besten Schnitts, überblendet oder, wie veröffentlicht, eingesetzt.</translation>
    </message>
    <message>
        <source>How patches join at the coarsest scale: the cut keeps contrast that the average, as published, loses.</source>
        <translation>Wie Patches auf der gröbsten Skala aneinander anschließen: Der Schnitt behält Kontrast, den das Mittel, wie veröffentlicht, verliert.</translation>
    </message>
    <message>
        <source>A batch is a JSON object; this is not one.</source>
        <translation>Ein Stapel ist ein JSON-Objekt; das hier ist keines.</translation>
    </message>
    <message>
        <source>A recipe is a JSON object; this is not one.</source>
        <translation>Ein Rezept ist ein JSON-Objekt; das hier ist keines.</translation>
    </message>
    <message>
        <source>A session is a JSON object; this is not one.</source>
        <translation>Eine Sitzung ist ein JSON-Objekt; das hier ist keines.</translation>
    </message>
    <message>
        <source>A sheet of {} × {} pictures of {} px is too large; compare fewer.</source>
        <translation>Ein Bogen mit {} × {} Bildern von {} px ist zu groß; vergleichen Sie weniger.</translation>
    </message>
    <message>
        <source>An image of {} × {} px with {} channels has no pixels.</source>
        <translation>Ein Bild von {} × {} px mit {} Kanälen hat keine Pixel.</translation>
    </message>
    <message>
        <source>An output of {} × {} px cannot wrap with a lattice of {:.0f} × {:.0f} px; make it at least that large, or set lattice=none.</source>
        <translation>Eine Ausgabe von {} × {} px lässt sich mit einem Gitter von {} × {} px nicht kacheln; machen Sie sie mindestens so groß, oder setzen Sie lattice=none.</translation>
    </message>
    <message>
        <source>An output of {} × {} px cannot wrap with a tile of {:.0f} × {:.0f} px; make it at least that large.</source>
        <translation>Eine Ausgabe von {} × {} px lässt sich mit einer Kachel von {} × {} px nicht kacheln; machen Sie sie mindestens so groß.</translation>
    </message>
    <message>
        <source>At the coarsest of {} scales {} is {} × {} px, smaller than the patch of {} px; choose fewer scales or a smaller patch.</source>
        <translation>In der gröbsten von {} Stufen ist {} {} × {} px groß, kleiner als der Patch von {} px; wählen Sie weniger Stufen oder einen kleineren Patch.</translation>
    </message>
    <message>
        <source>Corner {} of the rectification lies at {:.1f}, {:.1f}, outside the image of {} × {} px.</source>
        <translation>Ecke {} der Entzerrung liegt bei {}, {}, außerhalb des Bildes von {} × {} px.</translation>
    </message>
    <message>
        <source>Finding the lattice takes {}, of which only {} are free; open a smaller exemplar.</source>
        <translation>Das Gitter zu finden braucht {}, wovon nur {} frei sind; öffnen Sie eine kleinere Vorlage.</translation>
    </message>
    <message>
        <source>No tile fits in the exemplar of {} × {} px.</source>
        <translation>Keine Kachel passt in die Vorlage von {} × {} px.</translation>
    </message>
    <message>
        <source>Portilla–Simoncelli learns from one exemplar or goes between 2, but {} were given.</source>
        <translation>Portilla–Simoncelli lernt von einer Vorlage oder geht zwischen zweien, gegeben sind aber {}.</translation>
    </message>
    <message>
        <source>The band of {} px must be from 2 px to half the images&apos; shorter side, {} px.</source>
        <translation>Das Band von {} px muss von 2 px bis zur halben kürzeren Seite der Bilder gehen, {} px.</translation>
    </message>
    <message>
        <source>The batch holds more than {} runs; divide it.</source>
        <translation>Der Stapel hat mehr als {} Läufe; teilen Sie ihn.</translation>
    </message>
    <message>
        <source>The batch is of format {}, made for a newer Texloom; this one reads up to {}.</source>
        <translation>Der Stapel hat Format {}, für ein neueres Texloom; dieses liest bis {}.</translation>
    </message>
    <message>
        <source>The batch&apos;s {} and {} would both write {}; put $index, or what sets them apart, into the name.</source>
        <translation>{} und {} des Stapels würden beide {} schreiben; nehmen Sie $index, oder was sie unterscheidet, in den Namen.</translation>
    </message>
    <message>
        <source>The crop of {} × {} px at {}, {} does not lie within the image of {} × {} px.</source>
        <translation>Der Ausschnitt von {} × {} px bei {}, {} liegt nicht ganz im Bild von {} × {} px.</translation>
    </message>
    <message>
        <source>The first image is {} × {} px, the second {} × {} px; crop one to the size of the other.</source>
        <translation>Das erste Bild ist {} × {} px groß, das zweite {} × {} px; schneiden Sie eines auf die Größe des anderen zu.</translation>
    </message>
    <message>
        <source>The folder {} cannot be made: {}.</source>
        <translation>Der Ordner {} lässt sich nicht anlegen: {}.</translation>
    </message>
    <message>
        <source>The image is {} × {} px, but the map was made from an exemplar of {} × {} px.</source>
        <translation>Das Bild ist {} × {} px groß, die Karte wurde aber aus einer Vorlage von {} × {} px gemacht.</translation>
    </message>
    <message>
        <source>The images have {} and {} channels; a map needs the same number in each.</source>
        <translation>Die Bilder haben {} und {} Kanäle; eine Karte braucht in allen gleich viele.</translation>
    </message>
    <message>
        <source>The lattice&apos;s tile of {:.0f} × {:.0f} px is larger than {} with {} × {} px; give shorter vectors, or set lattice=none.</source>
        <translation>Die Masche des Gitters von {} × {} px ist größer als {} mit {} × {} px; geben Sie kürzere Vektoren an, oder setzen Sie lattice=none.</translation>
    </message>
    <message>
        <source>The map needs the images that it was made from, but none was given.</source>
        <translation>Die Karte braucht die Bilder, aus denen sie gemacht wurde, es wurde aber keines gegeben.</translation>
    </message>
    <message>
        <source>The mask hides all of {}; mask less.</source>
        <translation>Die Maske verdeckt alles von {}; maskieren Sie weniger.</translation>
    </message>
    <message>
        <source>The mask leaves no whole patch of {} px to copy; choose smaller blocks or mask less.</source>
        <translation>Die Maske lässt keinen ganzen Patch von {} px zum Kopieren; wählen Sie kleinere Blöcke, oder maskieren Sie weniger.</translation>
    </message>
    <message>
        <source>The mask leaves no whole tile of {:.0f} × {:.0f} px to copy; mask less.</source>
        <translation>Die Maske lässt keine ganze Kachel von {} × {} px zum Kopieren; maskieren Sie weniger.</translation>
    </message>
    <message>
        <source>The name {} holds a $ without a word after it; write $$ for a dollar sign.</source>
        <translation>Der Name {} enthält ein $ ohne Wort dahinter; schreiben Sie $$ für ein Dollarzeichen.</translation>
    </message>
    <message>
        <source>The output cannot be {} × {} px: its sides go from 1 to {} px.</source>
        <translation>Die Ausgabe kann nicht {} × {} px groß sein: ihre Seiten gehen von 1 bis {} px.</translation>
    </message>
    <message>
        <source>The pasted picture could not be kept in {}; check that there is room.</source>
        <translation>Das eingefügte Bild ließ sich nicht in {} ablegen; sehen Sie nach, ob dort Platz ist.</translation>
    </message>
    <message>
        <source>The preset is of format {}, made by a newer Texloom; this one ({}) reads up to {}.</source>
        <translation>Die Vorgabe hat Format {}, von einem neueren Texloom; dieses ({}) liest bis {}.</translation>
    </message>
    <message>
        <source>The recipe is of format {}, made by a newer Texloom; this one ({}) reads up to {}.</source>
        <translation>Das Rezept hat Format {}, von einem neueren Texloom; dieses ({}) liest bis {}.</translation>
    </message>
    <message>
        <source>The rectified image would be {} × {} px; each side is 1 to {} px.</source>
        <translation>Das entzerrte Bild wäre {} × {} px groß; jede Seite hat 1 bis {} px.</translation>
    </message>
    <message>
        <source>The region of {} × {} px at ({}, {}) does not lie in the output of {} × {} px.</source>
        <translation>Der Teil von {} × {} px bei ({}, {}) liegt nicht in der Ausgabe von {} × {} px.</translation>
    </message>
    <message>
        <source>The seed “{}” is not a whole number from 0 to {}.</source>
        <translation>Der Startwert „{}“ ist keine ganze Zahl von 0 bis {}.</translation>
    </message>
    <message>
        <source>The session has no exemplar in use.</source>
        <translation>Die Sitzung hat keine Vorlage in Gebrauch.</translation>
    </message>
    <message>
        <source>The session is of format {}, made by a newer Texloom; this one ({}) reads up to {}.</source>
        <translation>Die Sitzung hat Format {}, von einem neueren Texloom; dieses ({}) liest bis {}.</translation>
    </message>
    <message>
        <source>The sweep&apos;s {} is for {}, which is not one of the methods of this run.</source>
        <translation>{} der Reihe ist für {}, das keines der Verfahren dieses Laufs ist.</translation>
    </message>
    <message>
        <source>The tile at ({}, {}) holds pixels that the mask hides; choose another corner.</source>
        <translation>Die Kachel bei ({}, {}) enthält Pixel, die die Maske verdeckt; wählen Sie eine andere Ecke.</translation>
    </message>
    <message>
        <source>The tile&apos;s corner ({}, {}) lies outside {} with {} × {} px.</source>
        <translation>Die Ecke ({}, {}) der Kachel liegt außerhalb von {} mit {} × {} px.</translation>
    </message>
    <message>
        <source>The weight of {} is {}; it goes from {} to {}.</source>
        <translation>Das Gewicht von {} ist {}; es geht von {} bis {}.</translation>
    </message>
    <message>
        <source>The {} has no {}.</source>
        <translation>{}: {} fehlt.</translation>
    </message>
    <message>
        <source>The {} holds a number that is too large.</source>
        <translation>{}: eine Zahl darin ist zu groß.</translation>
    </message>
    <message>
        <source>The {} is nested more than {} levels deep.</source>
        <translation>{}: mehr als {} Ebenen tief verschachtelt.</translation>
    </message>
    <message>
        <source>The {} is not JSON: it breaks off or goes wrong at byte {}.</source>
        <translation>{}: kein JSON; es bricht bei Byte {} ab oder ist dort falsch.</translation>
    </message>
    <message>
        <source>The {}&apos;s {} is {}; it must be {}.</source>
        <translation>{}: {} ist {}; verlangt ist {}.</translation>
    </message>
    <message>
        <source>There are no values for {}.</source>
        <translation>Für {} gibt es keine Werte.</translation>
    </message>
    <message>
        <source>There is no exemplar to learn from.</source>
        <translation>Es gibt keine Vorlage zum Lernen.</translation>
    </message>
    <message>
        <source>There is no file {}.</source>
        <translation>Es gibt keine Datei {}.</translation>
    </message>
    <message>
        <source>There is not enough memory for an image of {} × {} px with {} channels ({}).</source>
        <translation>Der Speicher reicht nicht für ein Bild von {} × {} px mit {} Kanälen ({}).</translation>
    </message>
    <message>
        <source>These are {} runs; a sweep has at most {}.</source>
        <translation>Das sind {} Läufe; eine Reihe hat höchstens {}.</translation>
    </message>
    <message>
        <source>To wrap at {} × {} px the lattice was changed by {:.1f} %; a multiple of {} × {} px needs no change.</source>
        <translation>Zum Kacheln mit {} × {} px wurde das Gitter um {} % verändert; ein Vielfaches von {} × {} px braucht keine Änderung.</translation>
    </message>
    <message>
        <source>To wrap at {} × {} px the tile was changed by {:.1f} %; a multiple of {} × {} px needs no change.</source>
        <translation>Zum Kacheln mit {} × {} px wurde die Kachel um {} % verändert; ein Vielfaches von {} × {} px braucht keine Änderung.</translation>
    </message>
    <message>
        <source>To wrap, the output of {} × {} px at the coarsest of {} scales must be at least the patch, {} px; choose fewer scales or a smaller patch.</source>
        <translation>Zum Kacheln muss die Ausgabe von {} × {} px in der gröbsten von {} Stufen mindestens so groß sein wie der Patch, {} px; wählen Sie weniger Stufen oder einen kleineren Patch.</translation>
    </message>
    <message>
        <source>To wrap, the output&apos;s {} of {} px must be at least the patch, {} px.</source>
        <translation>Zum Kacheln muss die Ausgabe ({}) von {} px mindestens so groß sein wie der Patch, {} px.</translation>
    </message>
    <message>
        <source>To wrap, the output&apos;s {} of {} px must be at least {} px.</source>
        <translation>Zum Kacheln muss die Ausgabe ({}) von {} px mindestens {} px haben.</translation>
    </message>
    <message>
        <source>Turned by {}°, too little of the image of {} × {} px would be left.</source>
        <translation>Um {}° gedreht, bliebe zu wenig vom Bild mit {} × {} px.</translation>
    </message>
    <message>
        <source>Weights of exemplars</source>
        <translation>Gewichte der Vorlagen</translation>
    </message>
    <message>
        <source>With two exemplars, how far the statistics go from the first to the second, before their own weights.</source>
        <translation>Bei zwei Vorlagen: wie weit die Statistik von der ersten zur zweiten geht, vor deren eigenen Gewichten.</translation>
    </message>
    <message>
        <source>companion map</source>
        <translation>Begleitkarte</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>on</source>
        <translation>ein</translation>
    </message>
    <message>
        <source>position map (16-bit)</source>
        <translation>Positionskarte (16 Bit)</translation>
    </message>
    <message>
        <source>position map (STMap)</source>
        <translation>Positionskarte (STMap)</translation>
    </message>
    <message>
        <source>recipe</source>
        <translation>Rezept</translation>
    </message>
    <message>
        <source>result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>{} cannot be read: this build has no reader for {}.</source>
        <translation>{} lässt sich nicht lesen: dieser Version fehlt ein Leser für {}.</translation>
    </message>
    <message>
        <source>{} cannot be read: {}.</source>
        <translation>{} lässt sich nicht lesen: {}.</translation>
    </message>
    <message>
        <source>{} cannot be written: it is a folder.</source>
        <translation>{} lässt sich nicht schreiben: es ist ein Ordner.</translation>
    </message>
    <message>
        <source>{} cannot be written: the folder {} is not writable.</source>
        <translation>{} lässt sich nicht schreiben: der Ordner {} ist schreibgeschützt.</translation>
    </message>
    <message>
        <source>{} cannot be written: the image has {} channels, and {} holds {}.</source>
        <translation>{} lässt sich nicht schreiben: das Bild hat {} Kanäle, und {} fasst {}.</translation>
    </message>
    <message>
        <source>{} cannot be written: the name ends in {}; Texloom writes .png, .jpg, .tif, .exr and .hdr.</source>
        <translation>{} lässt sich nicht schreiben: der Name endet auf {}; Texloom schreibt .png, .jpg, .tif, .exr und .hdr.</translation>
    </message>
    <message>
        <source>{} cannot be written: there is no folder {}.</source>
        <translation>{} lässt sich nicht schreiben: es gibt keinen Ordner {}.</translation>
    </message>
    <message>
        <source>{} cannot be written: {} does not hold {} samples.</source>
        <translation>{} lässt sich nicht schreiben: {} fasst keine Werte der Tiefe {}.</translation>
    </message>
    <message>
        <source>{} cannot be written: {}.</source>
        <translation>{} lässt sich nicht schreiben: {}.</translation>
    </message>
    <message>
        <source>{} cannot hold a position map; its name ends in .exr (STMap, float) or .png (16-bit).</source>
        <translation>{} kann keine Positionskarte enthalten; ihr Name endet auf .exr (STMap, Gleitkomma) oder .png (16 Bit).</translation>
    </message>
    <message>
        <source>{} cannot make a part of an output alone; make all of it.</source>
        <translation>{} kann keinen Teil einer Ausgabe allein machen; machen Sie sie ganz.</translation>
    </message>
    <message>
        <source>{} cannot make an output that wraps.</source>
        <translation>{} kann keine kachelbare Ausgabe machen.</translation>
    </message>
    <message>
        <source>{} cannot start from an image.</source>
        <translation>{} kann nicht mit einem Bild beginnen.</translation>
    </message>
    <message>
        <source>{} changed since this result was made.</source>
        <translation>{} hat sich geändert, seit dieses Ergebnis gemacht wurde.</translation>
    </message>
    <message>
        <source>{} could not be copied to {}: {}.</source>
        <translation>{} ließ sich nicht nach {} kopieren: {}.</translation>
    </message>
    <message>
        <source>{} does not say the size of its exemplar; name the exemplar too.</source>
        <translation>{} sagt nicht, wie groß die Vorlage ist; geben Sie auch die Vorlage an.</translation>
    </message>
    <message>
        <source>{} has no pixels.</source>
        <translation>{} hat keine Pixel.</translation>
    </message>
    <message>
        <source>{} has {} channels; images with up to {} can be opened.</source>
        <translation>{} hat {} Kanäle; geöffnet werden Bilder mit bis zu {}.</translation>
    </message>
    <message>
        <source>{} holds no recipe.</source>
        <translation>{} enthält kein Rezept.</translation>
    </message>
    <message>
        <source>{} is a {} image; only flat ones can be opened.</source>
        <translation>{} ist ein Bild der Art {}; geöffnet werden nur flache.</translation>
    </message>
    <message>
        <source>{} is empty (0 bytes).</source>
        <translation>{} ist leer (0 Byte).</translation>
    </message>
    <message>
        <source>{} is not an image that Texloom reads (PNG, JPEG, TIFF, EXR or HDR).</source>
        <translation>{} ist kein Bild, das Texloom liest (PNG, JPEG, TIFF, EXR oder HDR).</translation>
    </message>
    <message>
        <source>{} is not of the result&apos;s size.</source>
        <translation>{} hat nicht die Größe des Ergebnisses.</translation>
    </message>
    <message>
        <source>{} is {} × {} px, smaller than the patch of {} px; choose a patch of at most {} px.</source>
        <translation>{} ist {} × {} px groß, kleiner als der Patch von {} px; wählen Sie einen Patch von höchstens {} px.</translation>
    </message>
    <message>
        <source>{} is {} × {} px, too small for blocks of {} px with their borders; choose blocks of at most {} px.</source>
        <translation>{} ist {} × {} px groß, zu klein für Blöcke von {} px mit ihren Rändern; wählen Sie Blöcke von höchstens {} px.</translation>
    </message>
    <message>
        <source>{} is {} × {} px; a tile is looked for in exemplars of at least {} × {} px.</source>
        <translation>{} ist {} × {} px groß; eine Kachel wird in Vorlagen von mindestens {} × {} px gesucht.</translation>
    </message>
    <message>
        <source>{} is {} × {} px; an exemplar&apos;s sides go up to {} px.</source>
        <translation>{} ist {} × {} px groß; die Seiten einer Vorlage gehen bis {} px.</translation>
    </message>
    <message>
        <source>{} is {} × {} px; images up to {} pixels can be opened.</source>
        <translation>{} ist {} × {} px groß; geöffnet werden Bilder bis {} Pixel.</translation>
    </message>
    <message>
        <source>{} is {} × {} px; near-regular synthesis needs exemplars of at least {} × {} px.</source>
        <translation>{} ist {} × {} px groß; die fast regelmäßige Synthese braucht Vorlagen von mindestens {} × {} px.</translation>
    </message>
    <message>
        <source>{} learns from one exemplar, but {} were given.</source>
        <translation>{} lernt von einer Vorlage, gegeben wurden aber {}.</translation>
    </message>
    <message>
        <source>{} says it is {} × {} px; an EXR&apos;s sides can go up to {} px.</source>
        <translation>{} sagt, es sei {} × {} px groß; die Seiten einer EXR gehen bis {} px.</translation>
    </message>
    <message>
        <source>{} takes {}, of which only {} are free; make a smaller result.</source>
        <translation>{} braucht {}, wovon nur {} frei sind; machen Sie ein kleineres Ergebnis.</translation>
    </message>
    <message>
        <source>{}: output pixel ({}, {}) comes from {:.2f}, between two pixels; a position map addresses whole ones (was it resampled, or is it for an exemplar of another size?).</source>
        <translation>{}: Pixel ({}, {}) der Ausgabe kommt von {}, zwischen zwei Pixeln; eine Positionskarte nennt ganze (wurde sie umgerechnet, oder ist sie für eine Vorlage anderer Größe?).</translation>
    </message>
    <message>
        <source>{}: output pixel ({}, {}) comes from {:.2f}, outside the exemplar&apos;s 0 to {}.</source>
        <translation>{}: Pixel ({}, {}) der Ausgabe kommt von {}, außerhalb von 0 bis {} der Vorlage.</translation>
    </message>
    <message>
        <source>“{}” is not from:to:count, such as 8:64:5, with a count of 2 to {}.</source>
        <translation>„{}“ ist nicht von:bis:Anzahl wie 8:64:5 mit einer Anzahl von 2 bis {}.</translation>
    </message>
    <message>
        <source>A box of {} voxels is empty; each side must be at least 1.</source>
        <translation>Ein Quader von {} Voxeln ist leer; jede Seite muss mindestens 1 sein.</translation>
    </message>
    <message>
        <source>A box of {} voxels takes {}, and {} of memory are free; ask for smaller ones.</source>
        <translation>Ein Quader von {} Voxeln braucht {}, und {} Speicher sind frei; kleinere gehen.</translation>
    </message>
    <message>
        <source>A slice goes {} voxels from pixel to pixel; it must be more than 0 and up to {}.</source>
        <translation>Ein Schnitt geht von Pixel zu Pixel {} Voxel weit; es müssen mehr als 0 und höchstens {} sein.</translation>
    </message>
    <message>
        <source>A slice of {} × {} px has no pixels.</source>
        <translation>Ein Schnitt von {} × {} px hat keine Pixel.</translation>
    </message>
    <message>
        <source>A volume of {} voxels with {} channels has no voxels.</source>
        <translation>Ein Volumen von {} Voxeln mit {} Kanälen hat keine Voxel.</translation>
    </message>
    <message>
        <source>The box from ({}, {}, {}) on lies too far out; coordinates go from −{} to {}.</source>
        <translation>Der Quader ab ({}, {}, {}) liegt zu weit draußen; Koordinaten gehen von −{} bis {}.</translation>
    </message>
    <message>
        <source>The box {} is not all within the volume, which has {}.</source>
        <translation>Der Quader {} liegt nicht ganz im Volumen; dieses hat {}.</translation>
    </message>
    <message>
        <source>The model of kind {} has no array {}; it was made by another version.</source>
        <translation>Das Modell der Art {} hat kein Feld {}; eine andere Version hat es gemacht.</translation>
    </message>
    <message>
        <source>The model&apos;s array {} has {} values and a shape of {}.</source>
        <translation>Das Feld {} des Modells hat {} Werte und die Form {}.</translation>
    </message>
    <message>
        <source>The model&apos;s array {} holds {} {}; {} {} are needed.</source>
        <translation>Das Feld {} des Modells enthält {} {}; nötig sind {} {}.</translation>
    </message>
    <message>
        <source>The slice lies beside the volume, which has {}.</source>
        <translation>Der Schnitt liegt neben dem Volumen; dieses hat {}.</translation>
    </message>
    <message>
        <source>The slice lies too far out; coordinates go from −{} to {}.</source>
        <translation>Der Schnitt liegt zu weit draußen; Koordinaten gehen von −{} bis {}.</translation>
    </message>
    <message>
        <source>The slice {} is missing; there are others from {} to {}.</source>
        <translation>Der Schnitt {} fehlt; andere sind da, von {} bis {}.</translation>
    </message>
    <message>
        <source>There is not enough memory for a volume of {} voxels with {} channels ({}).</source>
        <translation>Der Speicher reicht nicht für ein Volumen von {} Voxeln mit {} Kanälen ({}).</translation>
    </message>
    <message>
        <source>{} and {} have the same number; slices of a volume are numbered one by one.</source>
        <translation>{} und {} haben dieselbe Nummer; die Schnitte eines Volumens sind einzeln nummeriert.</translation>
    </message>
    <message>
        <source>{} became shorter while it was read.</source>
        <translation>{} wurde kürzer, während es gelesen wurde.</translation>
    </message>
    <message>
        <source>{} does not describe a volume.</source>
        <translation>{} beschreibt kein Volumen.</translation>
    </message>
    <message>
        <source>{} has a face of {} corners; faces can have up to {}.</source>
        <translation>{} hat eine Fläche mit {} Ecken; Flächen haben höchstens {}.</translation>
    </message>
    <message>
        <source>{} has faces without a list of vertices.</source>
        <translation>{} hat Flächen ohne eine Liste von Ecken.</translation>
    </message>
    <message>
        <source>{} has more than {} normals; no mesh can have more.</source>
        <translation>{} hat mehr als {} Normalen; mehr kann kein Netz haben.</translation>
    </message>
    <message>
        <source>{} has more than {} texture coordinates; no mesh can have more.</source>
        <translation>{} hat mehr als {} Texturkoordinaten; mehr kann kein Netz haben.</translation>
    </message>
    <message>
        <source>{} has more than {} triangles; no mesh can have more.</source>
        <translation>{} hat mehr als {} Dreiecke; mehr kann kein Netz haben.</translation>
    </message>
    <message>
        <source>{} has more than {} vertices; no mesh can have more.</source>
        <translation>{} hat mehr als {} Ecken; mehr kann kein Netz haben.</translation>
    </message>
    <message>
        <source>{} has no faces with an area ({} without one); there is nothing to see.</source>
        <translation>{} hat keine Flächen mit einem Inhalt ({} ohne); es gibt nichts zu sehen.</translation>
    </message>
    <message>
        <source>{} has vertices without x, y and z.</source>
        <translation>{} hat Ecken ohne x, y und z.</translation>
    </message>
    <message>
        <source>{} has {} bytes; {} voxels with {} channels, as {} says, take {}.</source>
        <translation>{} hat {} Byte; {} Voxel mit {} Kanälen, wie {} sagt, brauchen {}.</translation>
    </message>
    <message>
        <source>{} holds arrays, but is no model of Texloom: its head names no kind of model.</source>
        <translation>{} enthält Felder, ist aber kein Modell von Texloom: Der Kopf nennt keine Art von Modell.</translation>
    </message>
    <message>
        <source>{} holds values at z = {} that are not finite numbers; Texloom needs finite ones.</source>
        <translation>{} enthält bei z = {} Werte, die keine endlichen Zahlen sind; Texloom braucht endliche.</translation>
    </message>
    <message>
        <source>{} holds values in its array {} that are not finite numbers; Texloom needs finite ones.</source>
        <translation>{} enthält im Feld {} Werte, die keine endlichen Zahlen sind; Texloom braucht endliche.</translation>
    </message>
    <message>
        <source>{} holds {} arrays; a model has up to {}.</source>
        <translation>{} enthält {} Felder; ein Modell hat höchstens {}.</translation>
    </message>
    <message>
        <source>{} is a damaged OBJ file.</source>
        <translation>{} ist eine beschädigte OBJ-Datei.</translation>
    </message>
    <message>
        <source>file {}</source>
        <translation>Datei {}</translation>
    </message>
    <message>
        <source>{} is a folder, not a file.</source>
        <translation>{} ist ein Ordner, keine Datei.</translation>
    </message>
    <message>
        <source>{} is not an ordinary file, so it is not read.</source>
        <translation>{} ist keine gewöhnliche Datei und wird deshalb nicht gelesen.</translation>
    </message>
    <message>
        <source>32-bit floats</source>
        <translation>32-Bit-Gleitkommazahlen</translation>
    </message>
    <message>
        <source>64-bit floats</source>
        <translation>64-Bit-Gleitkommazahlen</translation>
    </message>
    <message>
        <source>64-bit integers</source>
        <translation>64-Bit-Ganzzahlen</translation>
    </message>
    <message>
        <source>the name of a file in the same folder</source>
        <translation>der Name einer Datei im selben Ordner</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true oder false</translation>
    </message>
    <message>
        <source>{} or more</source>
        <translation>{} oder mehr</translation>
    </message>
    <message>
        <source>a whole number from −{} to {}</source>
        <translation>eine ganze Zahl von −{} bis {}</translation>
    </message>
    <message>
        <source>{} is a model in format {}; this Texloom reads formats up to {}. A newer one reads it.</source>
        <translation>{} ist ein Modell im Format {}; dieses Texloom liest Formate bis {}. Ein neueres liest es.</translation>
    </message>
    <message>
        <source>{} is a volume in format {}; this Texloom reads formats up to {}. A newer one reads it.</source>
        <translation>{} ist ein Volumen im Format {}; dieses Texloom liest Formate bis {}. Ein neueres liest es.</translation>
    </message>
    <message>
        <source>{} is a volume of {} channels; volumes with up to {} can be opened.</source>
        <translation>{} ist ein Volumen mit {} Kanälen; öffnen lassen sich Volumen mit bis zu {}.</translation>
    </message>
    <message>
        <source>{} is a volume of {} voxels and takes {}; {} of memory are free.</source>
        <translation>{} ist ein Volumen von {} Voxeln und braucht {}; {} Speicher sind frei.</translation>
    </message>
    <message>
        <source>{} is a volume of {} voxels; volumes up to {} voxels can be opened.</source>
        <translation>{} ist ein Volumen von {} Voxeln; öffnen lassen sich Volumen bis {} Voxel.</translation>
    </message>
    <message>
        <source>{} is damaged or no model: a name in its head is empty, longer than {} bytes or holds control characters.</source>
        <translation>{} ist beschädigt oder kein Modell: Ein Name im Kopf ist leer, länger als {} Byte oder enthält Steuerzeichen.</translation>
    </message>
    <message>
        <source>{} is damaged or no model: its array {} does not say a type (F32, F64 or I64), a shape of up to {} axes and a place.</source>
        <translation>{} ist beschädigt oder kein Modell: Das Feld {} nennt keinen Typ (F32, F64 oder I64), keine Form mit höchstens {} Achsen oder keinen Ort.</translation>
    </message>
    <message>
        <source>{} is damaged or no model: its head is said to have {} bytes; it can have up to {}.</source>
        <translation>{} ist beschädigt oder kein Modell: Der Kopf soll {} Byte haben; höchstens {} sind möglich.</translation>
    </message>
    <message>
        <source>{} is damaged: a number in it is none.</source>
        <translation>{} ist beschädigt: Wo eine Zahl stehen muss, steht keine.</translation>
    </message>
    <message>
        <source>{} is damaged: it breaks off before its last face.</source>
        <translation>{} ist beschädigt: Es bricht vor der letzten Fläche ab.</translation>
    </message>
    <message>
        <source>{} is damaged: it holds {} where a whole number must be.</source>
        <translation>{} ist beschädigt: Es enthält {}, wo eine ganze Zahl stehen muss.</translation>
    </message>
    <message>
        <source>{} is damaged: its array {} begins at byte {}, not at {} where the one before it ends.</source>
        <translation>{} ist beschädigt: Das Feld {} beginnt bei Byte {}, nicht bei {}, wo das vorige endet.</translation>
    </message>
    <message>
        <source>{} is damaged: its array {} has a shape of {} and room from byte {} to {}.</source>
        <translation>{} ist beschädigt: Das Feld {} hat die Form {} und Platz von Byte {} bis {}.</translation>
    </message>
    <message>
        <source>{} is damaged: its arrays take {} bytes, and it holds {}.</source>
        <translation>{} ist beschädigt: Die Felder brauchen {} Byte, und es enthält {}.</translation>
    </message>
    <message>
        <source>{} is damaged: its head has the line “{}”.</source>
        <translation>{} ist beschädigt: Im Kopf steht die Zeile „{}“.</translation>
    </message>
    <message>
        <source>{} is damaged: {} numbers of a surface do not lie within the {} bytes of their buffer.</source>
        <translation>{} ist beschädigt: {} Zahlen einer Fläche liegen nicht in den {} Byte ihres Puffers.</translation>
    </message>
    <message>
        <source>{} is no PLY file that can be read: its head does not end, or does not say its format.</source>
        <translation>{} ist keine lesbare PLY-Datei: Der Kopf endet nicht oder nennt kein Format.</translation>
    </message>
    <message>
        <source>{} is no model of Texloom: its format is {}, not a number.</source>
        <translation>{} ist kein Modell von Texloom: Das Format ist {}, keine Zahl.</translation>
    </message>
    <message>
        <source>{} is no model: it has {} bytes.</source>
        <translation>{} ist kein Modell: Es hat {} Byte.</translation>
    </message>
    <message>
        <source>{} is no model: its head is not JSON.</source>
        <translation>{} ist kein Modell: Der Kopf ist kein JSON.</translation>
    </message>
    <message>
        <source>{} is no slice of a volume: its name does not end in a number of up to {} digits.</source>
        <translation>{} ist kein Schnitt eines Volumens: Der Name endet nicht mit einer Zahl von höchstens {} Ziffern.</translation>
    </message>
    <message>
        <source>{} is not a mesh that Texloom reads (OBJ, PLY or glTF).</source>
        <translation>{} ist kein Netz, das Texloom liest (OBJ, PLY oder glTF).</translation>
    </message>
    <message>
        <source>{} is not the file that {} was written for: its SHA-1 is another.</source>
        <translation>{} ist nicht die Datei, zu der {} geschrieben wurde: Ihr SHA-1 ist ein anderer.</translation>
    </message>
    <message>
        <source>{} already exists and would be taken for a part of this volume of {} slices; remove it or choose another name.</source>
        <translation>{} ist schon da und würde für einen Teil dieses Volumens von {} Schnitten gehalten; löschen Sie es oder wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>{} is {} long; a glTF file can have up to {}.</source>
        <translation>{} ist {} lang; eine glTF-Datei hat höchstens {}.</translation>
    </message>
    <message>
        <source>{} is {} long; models are read up to {}.</source>
        <translation>{} ist {} lang; Modelle werden bis {} gelesen.</translation>
    </message>
    <message>
        <source>{} needs the extension {}, which Texloom does not read; save it without compression.</source>
        <translation>{} braucht die Erweiterung {}, die Texloom nicht liest; speichern Sie es ohne Kompression.</translation>
    </message>
    <message>
        <source>{} says that it has {} elements of the kind {}; there is room for {}.</source>
        <translation>{} soll {} Elemente der Art {} haben; Platz ist für {}.</translation>
    </message>
    <message>
        <source>{}: a face uses normal {}; there are {}.</source>
        <translation>{}: Eine Fläche benutzt Normale {}; es gibt {}.</translation>
    </message>
    <message>
        <source>{}: a face uses texture coordinate {}; there are {}.</source>
        <translation>{}: Eine Fläche benutzt Texturkoordinate {}; es gibt {}.</translation>
    </message>
    <message>
        <source>{}: a face uses vertex {}; there are {}.</source>
        <translation>{}: Eine Fläche benutzt Ecke {}; es gibt {}.</translation>
    </message>
    <message>
        <source>{}: a surface has no positions of 32-bit floats, or other numbers of normals or texture coordinates.</source>
        <translation>{}: Eine Fläche hat keine Positionen aus 32-Bit-Gleitkommazahlen oder eine andere Anzahl von Normalen oder Texturkoordinaten.</translation>
    </message>
    <message>
        <source>{}: its nodes are missing, nested more than {} deep or more than {}.</source>
        <translation>{}: Seine Knoten fehlen, sind tiefer als {} verschachtelt oder mehr als {}.</translation>
    </message>
    <message>
        <source>{}: normal {} is not a finite vector.</source>
        <translation>{}: Normale {} ist kein endlicher Vektor.</translation>
    </message>
    <message>
        <source>{}: texture coordinate {} is not a finite pair of numbers.</source>
        <translation>{}: Texturkoordinate {} ist kein Paar endlicher Zahlen.</translation>
    </message>
    <message>
        <source>{}: the numbers of a surface are missing, sparse or of another kind than they must be.</source>
        <translation>{}: Die Zahlen einer Fläche fehlen, sind dünn besetzt oder von anderer Art, als sie sein müssen.</translation>
    </message>
    <message>
        <source>{}: the numbers of a surface lie in no buffer, or are of no known type.</source>
        <translation>{}: Die Zahlen einer Fläche liegen in keinem Puffer oder sind von keinem bekannten Typ.</translation>
    </message>
    <message>
        <source>{}: vertex {} lies at ({}, {}, {}); coordinates must be numbers of up to {}.</source>
        <translation>{}: Ecke {} liegt bei ({}, {}, {}); Koordinaten müssen Zahlen bis {} sein.</translation>
    </message>
    <message>
        <source>&quot;&quot;, &quot;x&quot;, &quot;y&quot; or &quot;xy&quot;</source>
        <translation>&quot;&quot;, &quot;x&quot;, &quot;y&quot; oder &quot;xy&quot;</translation>
    </message>
    <message>
        <source>--shard {}: write it as I/N with I from 1 to N, as 3/8.</source>
        <translation>--shard {}: als I/N zu schreiben, mit I von 1 bis N, etwa 3/8.</translation>
    </message>
    <message>
        <source>1 to {}</source>
        <translation>1 bis {}</translation>
    </message>
    <message>
        <source>A compact set of {} tiles need not close over a border; choose a full set for outputs that wrap.</source>
        <translation>Ein kompakter Satz von {} Kacheln schließt sich nicht unbedingt über den Rand; wählen Sie für kachelbare Ausgaben einen vollständigen Satz.</translation>
    </message>
    <message>
        <source>An image of the result&apos;s size that the method begins with.</source>
        <translation>Ein Bild in der Größe des Ergebnisses, mit dem das Verfahren beginnt.</translation>
    </message>
    <message>
        <source>Blocks of {} px hold whole ones.</source>
        <translation>Blöcke von {} px fassen ganze.</translation>
    </message>
    <message>
        <source>Changes noise, or an initial image, from coarse to fine until its patches are distributed as the exemplar&apos;s are. New pixels rather than copies; keeps all the exemplar&apos;s patches in use, and mixes several exemplars by their weights.</source>
        <translation>Ändert Rauschen oder ein Startbild von grob nach fein, bis seine Patches so verteilt sind wie die der Vorlage. Neue Pixel statt Kopien; benutzt alle Patches der Vorlage und mischt mehrere Vorlagen nach ihren Gewichten.</translation>
    </message>
    <message>
        <source>Changing low frequencies</source>
        <translation>Tiefe Frequenzen ändern</translation>
    </message>
    <message>
        <source>Compact</source>
        <translation>Kompakt</translation>
    </message>
    <message>
        <source>Companion maps</source>
        <translation>Begleitkarten</translation>
    </message>
    <message>
        <source>Cut-off</source>
        <translation>Grenze</translation>
    </message>
    <message>
        <source>Cutting tiles</source>
        <translation>Kacheln schneiden</translation>
    </message>
    <message>
        <source>Detail patch</source>
        <translation>Patch der Details</translation>
    </message>
    <message>
        <source>Deviation of the Gaussian that parts the bands: larger changes only what is slower, 0 changes everything.</source>
        <translation>Standardabweichung der Gaußfunktion, die die Bänder trennt: Größer ändert nur, was langsamer ist, 0 ändert alles.</translation>
    </message>
    <message>
        <source>Deviation, {}</source>
        <translation>Abweichung, {}</translation>
    </message>
    <message>
        <source>Directions</source>
        <translation>Richtungen</translation>
    </message>
    <message>
        <source>Distance of patches</source>
        <translation>Abstand der Patches</translation>
    </message>
    <message>
        <source>Drawing the tile set</source>
        <translation>Kachelsatz zeichnen</translation>
    </message>
    <message>
        <source>Draws of samples</source>
        <translation>Ziehungen der Proben</translation>
    </message>
    <message>
        <source>Error of the worst cut</source>
        <translation>Fehler des schlechtesten Schnitts</translation>
    </message>
    <message>
        <source>Error of the worst cut at which no more samples are drawn, over the error of unlike pixels: smaller searches longer.</source>
        <translation>Fehler des schlechtesten Schnitts, bei dem keine Proben mehr gezogen werden, im Verhältnis zu dem ungleicher Pixel: Kleiner sucht länger.</translation>
    </message>
    <message>
        <source>Full</source>
        <translation>Vollständig</translation>
    </message>
    <message>
        <source>Good enough</source>
        <translation>Gut genug</translation>
    </message>
    <message>
        <source>How often the samples are drawn again, at most, until the worst cut is good enough; the best are kept.</source>
        <translation>Wie oft die Proben höchstens neu gezogen werden, bis der schlechteste Schnitt gut genug ist; die besten bleiben.</translation>
    </message>
    <message>
        <source>Keeps the detail of the exemplar, or of an initial image, and draws the phase of its slow changes at random, so that stains and shades lie elsewhere. Suits metal and stone seen from afar; where detail follows the shades, as in wood, the two part.</source>
        <translation>Behält die Details der Vorlage oder eines Anfangsbilds und zieht die Phase ihrer langsamen Änderungen zufällig, sodass Flecken und Schattierungen woanders liegen. Passt zu Metall und Stein aus der Ferne; wo Details den Schattierungen folgen, wie bei Holz, gehen beide auseinander.</translation>
    </message>
    <message>
        <source>Keeps the strength of each frequency of the exemplar and draws its phase at random. Instant, and without any repetition; suits fine-grained textures such as sand, plaster or cloth, and loses edges and objects.</source>
        <translation>Behält die Stärke jeder Frequenz der Vorlage und zieht ihre Phase zufällig. Im Nu und ohne jede Wiederholung; gut für feinkörnige Texturen wie Sand, Putz oder Stoff, verliert Kanten und Gegenstände.</translation>
    </message>
    <message>
        <source>Laying tiles</source>
        <translation>Kacheln legen</translation>
    </message>
    <message>
        <source>Maps of the exemplar&apos;s size, such as normals or heights, that get the result&apos;s layout.</source>
        <translation>Karten in der Größe der Vorlage, etwa Normalen oder Höhen, die die Anordnung des Ergebnisses bekommen.</translation>
    </message>
    <message>
        <source>Mask</source>
        <translation>Maske</translation>
    </message>
    <message>
        <source>Matching patches</source>
        <translation>Patches werden zugeordnet</translation>
    </message>
    <message>
        <source>Most rounds for each patch size on each scale: more join better, but take longer.</source>
        <translation>Höchstens so viele je Patchgröße und Skala: mehr schließen besser an, dauern aber länger.</translation>
    </message>
    <message>
        <source>Most rounds on each scale but the finest: more join better, but take longer.</source>
        <translation>Höchstens so viele auf jeder Skala außer der feinsten: mehr schließen besser an, dauern aber länger.</translation>
    </message>
    <message>
        <source>Most rounds on the finest scale, where most of the time is spent.</source>
        <translation>Höchstens so viele auf der feinsten Skala, auf der die meiste Zeit vergeht.</translation>
    </message>
    <message>
        <source>Most scales, each half the size of the one before: more keep larger structures.</source>
        <translation>Höchstens so viele, jede halb so groß wie die vorige: mehr erhalten größere Strukturen.</translation>
    </message>
    <message>
        <source>Near-regular</source>
        <translation>Fast regelmäßig</translation>
    </message>
    <message>
        <source>Networks</source>
        <translation>Netze</translation>
    </message>
    <message>
        <source>Occurrence {}</source>
        <translation>Häufigkeit {}</translation>
    </message>
    <message>
        <source>One slope over the whole</source>
        <translation>Ein Verlauf über alles</translation>
    </message>
    <message>
        <source>Optimisation</source>
        <translation>Optimierung</translation>
    </message>
    <message>
        <source>Patch distribution</source>
        <translation>Patchverteilung</translation>
    </message>
    <message>
        <source>Pixel by pixel</source>
        <translation>Pixel für Pixel</translation>
    </message>
    <message>
        <source>Pixels of the exemplar where it is black are never used.</source>
        <translation>Pixel der Vorlage, an denen sie schwarz ist, werden nie benutzt.</translation>
    </message>
    <message>
        <source>Position map</source>
        <translation>Positionskarte</translation>
    </message>
    <message>
        <source>Random directions along which patches are compared in one iteration: more make each iteration surer and longer.</source>
        <translation>Zufällige Richtungen, in denen Patches in einem Durchlauf verglichen werden: mehr machen jeden Durchlauf sicherer und länger.</translation>
    </message>
    <message>
        <source>Random low frequencies</source>
        <translation>Zufällige tiefe Frequenzen</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Scale 1/{}</source>
        <translation>Skala 1/{}</translation>
    </message>
    <message>
        <source>Scale 1/{}, patches of {} px</source>
        <translation>Skala 1/{}, Patches von {} px</translation>
    </message>
    <message>
        <source>Set</source>
        <translation>Satz</translation>
    </message>
    <message>
        <source>Side of a tile: larger repeats less and keeps larger structures, smaller has more edges.</source>
        <translation>Seite einer Kachel: Größer wiederholt sich weniger und behält größere Strukturen, kleiner hat mehr Kanten.</translation>
    </message>
    <message>
        <source>Side of the compared patches at each scale: larger keeps larger structures whole and takes longer.</source>
        <translation>Seite der verglichenen Patches je Skala: größere halten größere Strukturen zusammen und dauern länger.</translation>
    </message>
    <message>
        <source>Solids</source>
        <translation>Körper</translation>
    </message>
    <message>
        <source>Sparse</source>
        <translation>Dünn besetzt</translation>
    </message>
    <message>
        <source>The checkpoint is of a run with other settings or exemplars; start the run again.</source>
        <translation>Der Zwischenstand gehört zu einem Lauf mit anderen Einstellungen oder Vorlagen; beginnen Sie den Lauf neu.</translation>
    </message>
    <message>
        <source>The earlier result in {} is left out: {}</source>
        <translation>Das frühere Ergebnis in {} bleibt weg: {}</translation>
    </message>
    <message>
        <source>The exemplar&apos;s pixel that each pixel of the result was copied from.</source>
        <translation>Das Pixel der Vorlage, von dem jedes Pixel des Ergebnisses kopiert wurde.</translation>
    </message>
    <message>
        <source>The four corners of the rectification must go clockwise from the top left around an area without a dent.</source>
        <translation>Die vier Ecken der Entzerrung müssen von links oben im Uhrzeigersinn um eine Fläche ohne Delle gehen.</translation>
    </message>
    <message>
        <source>The image to learn from.</source>
        <translation>Das Bild, von dem gelernt wird.</translation>
    </message>
    <message>
        <source>The input {} of {} takes {}.</source>
        <translation>Der Eingang {} von {} nimmt: {}.</translation>
    </message>
    <message>
        <source>The lattice&apos;s tile of {:.0f} × {:.0f} px is larger than the blocks of {} px, so new ones are pieced together from parts of several. {}</source>
        <translation>Die Masche des Gitters von {} × {} px ist größer als die Blöcke von {} px, sodass neue aus Teilen mehrerer zusammengesetzt werden. {}</translation>
    </message>
    <message>
        <source>The lattice&apos;s vectors ({}, {}) and ({}, {}) px do not span a tile; give two that do not lie on one line.</source>
        <translation>Die Vektoren ({}, {}) und ({}, {}) px des Gitters spannen keine Masche auf; geben Sie zwei an, die nicht auf einer Linie liegen.</translation>
    </message>
    <message>
        <source>The light in {} varies so much that patches would show, so it was evened out; flatten=no keeps it.</source>
        <translation>Das Licht von {} ändert sich so stark von Ort zu Ort, dass Flicken auffielen; darum wurde es ausgeglichen. flatten=no behält es.</translation>
    </message>
    <message>
        <source>The map needs one image for each exemplar that it was made from: {}, not {}.</source>
        <translation>Die Karte braucht ein Bild je Vorlage, aus der sie gemacht wurde: {}, nicht {}.</translation>
    </message>
    <message>
        <source>The mask leaves no whole sample of {} px for tiles of {} px; choose smaller tiles or mask less.</source>
        <translation>Die Maske lässt keine ganze Probe von {} px für Kacheln von {} px frei; wählen Sie kleinere Kacheln oder maskieren Sie weniger.</translation>
    </message>
    <message>
        <source>The method treats all exemplars alike, so their weights had no effect.</source>
        <translation>Das Verfahren nimmt alle Vorlagen gleich, sodass ihre Gewichte nichts bewirkten.</translation>
    </message>
    <message>
        <source>The name {} holds ${}, which stands for nothing here; use {}.</source>
        <translation>Der Name {} enthält ${}, das hier für nichts steht; nehmen Sie {}.</translation>
    </message>
    <message>
        <source>The picture for “{}” is {} × {} px, but {} is {} × {} px; it must be of that size.</source>
        <translation>Das Bild für „{}“ ist {} × {} px groß, {} aber {} × {} px; es muss so groß sein.</translation>
    </message>
    <message>
        <source>The rows, {:.0f} px apart, are larger than the blocks of {} px, so new ones are pieced together from parts of several. {}</source>
        <translation>Die Reihen im Abstand von {} px sind größer als die Blöcke von {} px, sodass neue aus Teilen mehrerer zusammengesetzt werden. {}</translation>
    </message>
    <message>
        <source>The run was stopped before it knew where its pixels come from, so there are no companion maps.</source>
        <translation>Der Lauf wurde angehalten, bevor feststand, woher seine Pixel kommen; darum gibt es keine Begleitkarten.</translation>
    </message>
    <message>
        <source>The texture that was made.</source>
        <translation>Die Textur, die entstanden ist.</translation>
    </message>
    <message>
        <source>The work ended for an unknown reason; try again.</source>
        <translation>Die Arbeit endete aus unbekanntem Grund; versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>The {} has an unknown field {}; the known ones are {}.</source>
        <translation>{}: das Feld {} ist hier nicht bekannt; bekannt sind {}.</translation>
    </message>
    <message>
        <source>The {} {} is {} × {} px, but {} is {} × {} px; they must be the same size.</source>
        <translation>{1} ({0}) ist {2} × {3} px groß, {4} aber {5} × {6} px; sie müssen gleich sein.</translation>
    </message>
    <message>
        <source>There is no colour space {}; choose one of {}.</source>
        <translation>Es gibt keinen Farbraum {}; wählen Sie einen von {}.</translation>
    </message>
    <message>
        <source>There is no export preset {}; choose one of {}.</source>
        <translation>Es gibt keine Exportvorgabe {}; wählen Sie eine von {}.</translation>
    </message>
    <message>
        <source>There is no kind of map {}; the kinds are {}.</source>
        <translation>Es gibt keine Kartenart {}; die Arten sind {}.</translation>
    </message>
    <message>
        <source>There is no method {}; the methods are {}.</source>
        <translation>Es gibt kein Verfahren {}; die Verfahren sind {}.</translation>
    </message>
    <message>
        <source>There is not enough memory for this; try a smaller output.</source>
        <translation>Dafür reicht der Speicher nicht; versuchen Sie eine kleinere Ausgabe.</translation>
    </message>
    <message>
        <source>Tile size</source>
        <translation>Kachelgröße</translation>
    </message>
    <message>
        <source>Tiles</source>
        <translation>Kacheln</translation>
    </message>
    <message>
        <source>Tiles of {} px take samples of {} × {} px, but {} is {} × {} px; choose smaller tiles or less overlap.</source>
        <translation>Kacheln von {} px brauchen Proben von {} × {} px, aber {} hat {} × {} px; wählen Sie kleinere Kacheln oder weniger Überlappung.</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>Tries</source>
        <translation>Versuche</translation>
    </message>
    <message>
        <source>Wang tiles</source>
        <translation>Wang-Kacheln</translation>
    </message>
    <message>
        <source>Where the output has another size and there is no initial image, detail is quilted from patches of this side: larger keeps larger structures whole.</source>
        <translation>Wo die Ausgabe eine andere Größe hat und es kein Anfangsbild gibt, werden Details aus Patches dieser Seite zusammengefügt: Größer lässt größere Strukturen ganz.</translation>
    </message>
    <message>
        <source>Works on the periodic component, without which the borders draw horizontal and vertical streaks. Outputs that wrap always need it.</source>
        <translation>Arbeitet mit der periodischen Komponente, ohne die die Ränder waagerechte und senkrechte Streifen zeichnen. Kachelbare Ausgaben brauchen sie immer.</translation>
    </message>
    <message>
        <source>a list of at least one method</source>
        <translation>eine Liste mit mindestens einem Verfahren</translation>
    </message>
    <message>
        <source>a list of {} to {}</source>
        <translation>eine Liste mit {} bis {} Einträgen</translation>
    </message>
    <message>
        <source>a mask</source>
        <translation>eine Maske</translation>
    </message>
    <message>
        <source>a mesh</source>
        <translation>ein Polygonnetz</translation>
    </message>
    <message>
        <source>a model</source>
        <translation>ein Modell</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>eine Zahl</translation>
    </message>
    <message>
        <source>a number, text, true or false</source>
        <translation>eine Zahl, ein Text, true oder false</translation>
    </message>
    <message>
        <source>a position map</source>
        <translation>eine Positionskarte</translation>
    </message>
    <message>
        <source>a volume</source>
        <translation>ein Volumen</translation>
    </message>
    <message>
        <source>a whole number from 0 to 18446744073709551615</source>
        <translation>eine ganze Zahl von 0 bis 18446744073709551615</translation>
    </message>
    <message>
        <source>a whole number that is not too large</source>
        <translation>eine ganze Zahl, die nicht zu groß ist</translation>
    </message>
    <message>
        <source>an image</source>
        <translation>ein Bild</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>ein Objekt</translation>
    </message>
    <message>
        <source>any number</source>
        <translation>eine beliebige Zahl</translation>
    </message>
    <message>
        <source>any whole number</source>
        <translation>eine beliebige ganze Zahl</translation>
    </message>
    <message>
        <source>batch</source>
        <translation>Stapel</translation>
    </message>
    <message>
        <source>companion</source>
        <translation>Begleitkarte</translation>
    </message>
    <message>
        <source>deep</source>
        <translation>Deep</translation>
    </message>
    <message>
        <source>entry</source>
        <translation>Eintrag</translation>
    </message>
    <message>
        <source>it was made by another version.</source>
        <translation>eine andere Version hat es gemacht.</translation>
    </message>
    <message>
        <source>its entry is damaged.</source>
        <translation>sein Eintrag ist beschädigt.</translation>
    </message>
    <message>
        <source>its kind of map is not known.</source>
        <translation>die Art seiner Karte ist nicht bekannt.</translation>
    </message>
    <message>
        <source>mask</source>
        <translation>Maske</translation>
    </message>
    <message>
        <source>on or off</source>
        <translation>ein oder aus</translation>
    </message>
    <message>
        <source>one of {}</source>
        <translation>eines von {}</translation>
    </message>
    <message>
        <source>preset</source>
        <translation>Vorgabe</translation>
    </message>
    <message>
        <source>session</source>
        <translation>Sitzung</translation>
    </message>
    <message>
        <source>text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>the disk may be full</source>
        <translation>vielleicht ist der Datenträger voll</translation>
    </message>
    <message>
        <source>the name of a file</source>
        <translation>der Name einer Datei</translation>
    </message>
    <message>
        <source>the output</source>
        <translation>die Ausgabe</translation>
    </message>
    <message>
        <source>volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>{} (other ones)</source>
        <translation>{} (andere)</translation>
    </message>
    <message>
        <source>{} = {}: {} goes from {}.</source>
        <translation>{} = {}: {} geht von {}.</translation>
    </message>
    <message>
        <source>{} = {}: {} is one of {}.</source>
        <translation>{} = {}: {} ist eines von {}.</translation>
    </message>
    <message>
        <source>{} = {}: {} is {}.</source>
        <translation>{} = {}: {} ist {}.</translation>
    </message>
    <message>
        <source>{} Did you mean {}?</source>
        <translation>{} Meinten Sie {}?</translation>
    </message>
    <message>
        <source>{} and {}</source>
        <translation>{} und {}</translation>
    </message>
    <message>
        <source>{} and {} have different numbers of channels, {} and {}; all exemplars need the same.</source>
        <translation>{} und {} haben verschieden viele Kanäle, {} und {}; alle Vorlagen brauchen gleich viele.</translation>
    </message>
    <message>
        <source>{} and {} have different numbers of companion maps, {} and {}; every exemplar needs the same ones.</source>
        <translation>{} und {} haben verschieden viele Begleitkarten, {} und {}; jede Vorlage braucht dieselben.</translation>
    </message>
    <message>
        <source>{} cannot be written: the name ends in nothing that names a format; Texloom writes .png, .jpg, .tif, .exr and .hdr.</source>
        <translation>{} lässt sich nicht schreiben: der Name nennt am Ende kein Format; Texloom schreibt .png, .jpg, .tif, .exr und .hdr.</translation>
    </message>
    <message>
        <source>{} copies no pixels, so it has no position map.</source>
        <translation>{} kopiert keine Pixel und hat darum keine Positionskarte.</translation>
    </message>
    <message>
        <source>{} has no input {}.</source>
        <translation>{} hat keinen Eingang {}.</translation>
    </message>
    <message>
        <source>{} has no input {}; it takes {}.</source>
        <translation>{} hat keinen Eingang {}; es nimmt {}.</translation>
    </message>
    <message>
        <source>{} has no parameter {}; it has {}.</source>
        <translation>{} hat keinen Parameter {}; es hat {}.</translation>
    </message>
    <message>
        <source>{} holds {} values that are not finite numbers, the first at pixel ({}, {}); save it without them.</source>
        <translation>{} enthält {} Werte, die keine endlichen Zahlen sind, den ersten bei Pixel ({}, {}); Texloom braucht endliche.</translation>
    </message>
    <message>
        <source>{} is a checkpoint of format {}; this Texloom ({}) reads format {}. Start the run again.</source>
        <translation>{} ist ein Zwischenstand im Format {}; dieses Texloom ({}) liest Format {}. Beginnen Sie den Lauf neu.</translation>
    </message>
    <message>
        <source>{} is a folder, not an image.</source>
        <translation>{} ist ein Ordner, kein Bild.</translation>
    </message>
    <message>
        <source>{} is longer than {}, too long for a file of this kind.</source>
        <translation>{} ist länger als {}, zu lang für eine Datei dieser Art.</translation>
    </message>
    <message>
        <source>{} is not a checkpoint, or it is damaged; start the run again.</source>
        <translation>{} ist kein Zwischenstand oder beschädigt; beginnen Sie den Lauf neu.</translation>
    </message>
    <message>
        <source>{} is not a position map: an STMap has 2 to 4 channels of 32-bit floats, but this file has {} of {}.</source>
        <translation>{} ist keine Positionskarte: eine STMap hat 2 bis 4 Kanäle mit 32-Bit-Gleitkomma, diese Datei {} mit {}.</translation>
    </message>
    <message>
        <source>{} is not a position map: as a PNG it has 3 channels of 16 bits, but this file has {} of {}.</source>
        <translation>{} ist keine Positionskarte: als PNG hat sie 3 Kanäle mit 16 Bit, diese Datei {} mit {}.</translation>
    </message>
    <message>
        <source>{} is not an ordinary file, so it is not an image.</source>
        <translation>{} ist keine gewöhnliche Datei und kein Bild.</translation>
    </message>
    <message>
        <source>{} is not part of this build. {}</source>
        <translation>{} gehört nicht zu dieser Ausgabe von Texloom. {}</translation>
    </message>
    <message>
        <source>{} names an exemplar of {} × {} px; sides go from 1 to {} px.</source>
        <translation>{} nennt eine Vorlage von {} × {} px; Seiten gehen von 1 bis {} px.</translation>
    </message>
    <message>
        <source>{} needs {} for its input {}, but {} were given.</source>
        <translation>{} braucht {} für den Eingang {}, gegeben wurden aber {}.</translation>
    </message>
    <message>
        <source>{} takes no exemplar.</source>
        <translation>{} nimmt keine Vorlage.</translation>
    </message>
    <message>
        <source>{} uses nothing that {} makes, so it cannot follow it.</source>
        <translation>{} kann nichts aufnehmen, was {} macht, und darum nicht darauf folgen.</translation>
    </message>
    <message>
        <source>{} takes {} for its input {}, but {} were given.</source>
        <translation>{} nimmt {} für den Eingang {}, gegeben wurden aber {}.</translation>
    </message>
    <message>
        <source>{} to {}</source>
        <translation>{} bis {}</translation>
    </message>
    <message>
        <source>{} to {} {}</source>
        <translation>{} bis {} {}</translation>
    </message>
    <message>
        <source>{} was not straightened, since too little of it would be left.</source>
        <translation>{} wurde nicht gerade gerichtet: es bliebe zu wenig übrig.</translation>
    </message>
    <message>
        <source>{} {}</source>
        <translation>{} {}</translation>
    </message>
    <message>
        <source>{} × {} px</source>
        <translation>{} × {} px</translation>
    </message>
    <message>
        <source>{}: {}</source>
        <translation>{}: {}</translation>
    </message>
    <message>
        <source>“Regular tile” repeats whole ones.</source>
        <translation>„Regelmäßige Kachel“ wiederholt ganze.</translation>
    </message>
    <message>
        <source>The worst cut&apos;s error is {:.2f} of that of unlike pixels, more than the {} wished for; more tries, larger tiles or fewer colours may help.</source>
        <translation>Der Fehler des schlechtesten Schnitts beträgt {} des Fehlers ungleicher Pixel, mehr als die gewünschten {}; mehr Versuche, größere Kacheln oder weniger Farben können helfen.</translation>
    </message>
    <message>
        <source>checkpoint</source>
        <translation>Zwischenstand</translation>
    </message>
    <message>
        <source>{} is damaged: an entry of its header says that it has {} bytes, but the file has {}.</source>
        <translation>{} ist beschädigt: ein Eintrag des Kopfs soll {} Bytes haben, aber die Datei hat {}.</translation>
    </message>
    <message>
        <source>A picture of the exemplar to compare with the target, such as its height or its labels; without one, the blurred luminance of both is compared.</source>
        <translation>Ein Bild der Vorlage, das mit dem Ziel verglichen wird, etwa ihre Höhe oder ihre Kennfarben; ohne eines wird die weichgezeichnete Helligkeit beider verglichen.</translation>
    </message>
    <message>
        <source>Blur</source>
        <translation>Weichzeichnung</translation>
    </message>
    <message>
        <source>Correspondence</source>
        <translation>Entsprechung</translation>
    </message>
    <message>
        <source>Gives the target&apos;s luminance the mean and the contrast of the exemplar&apos;s, so that dark targets, too, find patches of all tones.</source>
        <translation>Gibt der Helligkeit des Ziels Mittelwert und Kontrast der Vorlage, damit auch dunkle Ziele Flicken aller Töne finden.</translation>
    </message>
    <message>
        <source>How much luminance is blurred before it is compared: larger heeds only broad light and dark.</source>
        <translation>Wie stark die Helligkeit vor dem Vergleich weichgezeichnet wird: mehr achtet nur auf großes Hell und Dunkel.</translation>
    </message>
    <message>
        <source>How much the joins count in the first pass; the target has the rest. 1 is plain quilting.</source>
        <translation>Wie viel die Anschlüsse im ersten Durchgang zählen; der Rest gehört dem Ziel. 1 ist gewöhnliches Quilting.</translation>
    </message>
    <message>
        <source>How much the joins, and the pass before, count in the last pass; the target has the rest.</source>
        <translation>Wie viel die Anschlüsse und der Durchgang davor im letzten Durchgang zählen; der Rest gehört dem Ziel.</translation>
    </message>
    <message>
        <source>How often the output is quilted over, each time with smaller patches: more follow the target more closely.</source>
        <translation>Wie oft die Ausgabe überarbeitet wird, jedes Mal mit kleineren Flicken: mehr folgen dem Ziel genauer.</translation>
    </message>
    <message>
        <source>Match tones</source>
        <translation>Töne angleichen</translation>
    </message>
    <message>
        <source>Passes</source>
        <translation>Durchgänge</translation>
    </message>
    <message>
        <source>Preparing the correspondence</source>
        <translation>Entsprechung vorbereiten</translation>
    </message>
    <message>
        <source>Shows a target picture in the exemplar&apos;s material: patches are quilted that follow the target&apos;s light and dark, with smaller patches in each pass.</source>
        <translation>Zeigt ein Zielbild im Material der Vorlage: Es werden Flicken gesetzt, die dem Hell und Dunkel des Ziels folgen, in jedem Durchgang kleinere.</translation>
    </message>
    <message>
        <source>Side of the patches in the first pass; each further pass takes two thirds of it. Larger shows more of the material, smaller more of the target.</source>
        <translation>Seite der Flicken im ersten Durchgang; jeder weitere nimmt zwei Drittel davon. Größere zeigen mehr vom Material, kleinere mehr vom Ziel.</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>Texture in the first pass</source>
        <translation>Textur im ersten Durchgang</translation>
    </message>
    <message>
        <source>Texture in the last pass</source>
        <translation>Textur im letzten Durchgang</translation>
    </message>
    <message>
        <source>Texture transfer</source>
        <translation>Texturübertragung</translation>
    </message>
    <message>
        <source>The picture that the result is to look like from afar, of the output&apos;s size.</source>
        <translation>Das Bild, dem das Ergebnis von weitem gleichen soll, in der Größe der Ausgabe.</translation>
    </message>
    <message>
        <source>{} has no picture that corresponds to the target, but another exemplar has; give one for each or for none.</source>
        <translation>{} hat kein Bild, das dem Ziel entspricht, aber eine andere Vorlage hat eines; bitte jeder eines geben oder keiner.</translation>
    </message>
    <message>
        <source>An edit is empty; write it as tool=value, with one of {}.</source>
        <translation>Eine Bearbeitung ist leer; schreiben Sie sie als Werkzeug=Wert, mit einem von {}.</translation>
    </message>
    <message>
        <source>An edit names no tool; those that edit are {}.</source>
        <translation>Eine Bearbeitung nennt kein Werkzeug; die zum Bearbeiten sind {}.</translation>
    </message>
    <message>
        <source>An edit with {} names no tool that is known here; those that edit are {}.</source>
        <translation>Eine Bearbeitung mit {} nennt kein Werkzeug, das hier bekannt ist; die zum Bearbeiten sind {}.</translation>
    </message>
    <message>
        <source>An output of {} × {} px is made in strips of {} rows, without position maps, companion maps or anything else beside it; choose a region or a smaller size to get those.</source>
        <translation>Eine Ausgabe von {} × {} px entsteht in Streifen von {} Zeilen, ohne Positionskarten, Begleitkarten oder anderes daneben; wählen Sie einen Ausschnitt oder eine kleinere Größe, um sie zu bekommen.</translation>
    </message>
    <message>
        <source>An output of {} × {} px would need {} of memory, more than {}; choose a smaller size.</source>
        <translation>Eine Ausgabe von {} × {} px bräuchte {} Speicher, mehr als {}; wählen Sie eine kleinere Größe.</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Bereich</translation>
    </message>
    <message>
        <source>As the file&apos;s tags say</source>
        <translation>Wie die Angaben in der Datei sagen</translation>
    </message>
    <message>
        <source>As they are (RGB)</source>
        <translation>Wie sie sind (RGB)</translation>
    </message>
    <message>
        <source>Band</source>
        <translation>Band</translation>
    </message>
    <message>
        <source>Bottom left</source>
        <translation>Unten links</translation>
    </message>
    <message>
        <source>Bottom right</source>
        <translation>Unten rechts</translation>
    </message>
    <message>
        <source>Circular</source>
        <translation>Kreisförmig</translation>
    </message>
    <message>
        <source>Clockwise, in degrees.</source>
        <translation>Im Uhrzeigersinn, in Grad.</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>Corners</source>
        <translation>Ecken</translation>
    </message>
    <message>
        <source>Cosine axes (DCT)</source>
        <translation>Kosinusachsen (DCT)</translation>
    </message>
    <message>
        <source>Crop</source>
        <translation>Zuschneiden</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Kurve</translation>
    </message>
    <message>
        <source>Cuts where the images differ least.</source>
        <translation>Schneidet, wo sich die Bilder am wenigsten unterscheiden.</translation>
    </message>
    <message>
        <source>Deforms both images until they agree; draws lines from the middle to the border.</source>
        <translation>Verformt beide Bilder, bis sie übereinstimmen; zieht Linien von der Mitte zum Rand.</translation>
    </message>
    <message>
        <source>Deforms both images until they agree; fades out evenly.</source>
        <translation>Verformt beide Bilder, bis sie übereinstimmen; klingt gleichmäßig ab.</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Fading</source>
        <translation>Abklingen</translation>
    </message>
    <message>
        <source>Horizontal</source>
        <translation>Waagrecht</translation>
    </message>
    <message>
        <source>How far from the curve, on either side, pixels may change: up to half the images&apos; shorter side.</source>
        <translation>Wie weit von der Kurve, auf beiden Seiten, sich Pixel ändern dürfen: bis zur halben kürzeren Seite der Bilder.</translation>
    </message>
    <message>
        <source>How midway blending fades out towards the border of the band.</source>
        <translation>Wie das Midway-Überblenden zum Rand des Bandes hin abklingt.</translation>
    </message>
    <message>
        <source>How much of the unevenness is taken out; 1 is all.</source>
        <translation>Wie viel der Ungleichmäßigkeit entfernt wird; 1 ist alles.</translation>
    </message>
    <message>
        <source>How often the light may bend over the exemplar: 1 is a plain slope.</source>
        <translation>Wie oft sich das Licht über die Vorlage biegen darf: 1 ist ein einfaches Gefälle.</translation>
    </message>
    <message>
        <source>How the images meet.</source>
        <translation>Wie die Bilder zusammentreffen.</translation>
    </message>
    <message>
        <source>Joins the gradients of both images.</source>
        <translation>Fügt die Gradienten beider Bilder zusammen.</translation>
    </message>
    <message>
        <source>Joins two images along a curve, so that the seam does not show.</source>
        <translation>Fügt zwei Bilder entlang einer Kurve zusammen, sodass die Naht nicht auffällt.</translation>
    </message>
    <message>
        <source>Keeps a rectangle of the exemplar.</source>
        <translation>Behält ein Rechteck der Vorlage.</translation>
    </message>
    <message>
        <source>Leaves the images as they are, to compare with.</source>
        <translation>Lässt die Bilder, wie sie sind, zum Vergleich.</translation>
    </message>
    <message>
        <source>Left and upper edge, width and height, in the exemplar as the edits before it left it.</source>
        <translation>Linke und obere Kante, Breite und Höhe, in der Vorlage nach den vorherigen Bearbeitungen.</translation>
    </message>
    <message>
        <source>Left to right</source>
        <translation>Links nach rechts</translation>
    </message>
    <message>
        <source>Makes a rectangle of a surface that was photographed at a slant.</source>
        <translation>Macht ein Rechteck aus einer Fläche, die schräg fotografiert wurde.</translation>
    </message>
    <message>
        <source>Midway, linear</source>
        <translation>Midway, linear</translation>
    </message>
    <message>
        <source>Midway, progressive</source>
        <translation>Midway, fortschreitend</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>Spiegeln</translation>
    </message>
    <message>
        <source>Mirror left to right</source>
        <translation>Links und rechts spiegeln</translation>
    </message>
    <message>
        <source>Mirror top to bottom</source>
        <translation>Oben und unten spiegeln</translation>
    </message>
    <message>
        <source>Not blended</source>
        <translation>Nicht überblendet</translation>
    </message>
    <message>
        <source>Of the rectangle; if not given, as long as the longer of opposite sides.</source>
        <translation>Des Rechtecks; ohne Angabe so lang wie die längere der gegenüberliegenden Seiten.</translation>
    </message>
    <message>
        <source>Poisson editing</source>
        <translation>Poisson-Bearbeitung</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Lage</translation>
    </message>
    <message>
        <source>Principal axes (PCA)</source>
        <translation>Hauptachsen (PCA)</translation>
    </message>
    <message>
        <source>Put the corners on four that are a rectangle in reality.</source>
        <translation>Setzen Sie die Ecken auf vier Punkte, die in Wirklichkeit ein Rechteck sind.</translation>
    </message>
    <message>
        <source>Rectify</source>
        <translation>Entzerren</translation>
    </message>
    <message>
        <source>Swaps left and right, or top and bottom.</source>
        <translation>Vertauscht links und rechts oder oben und unten.</translation>
    </message>
    <message>
        <source>Takes slow changes of brightness out of the colours, so that parts from light and dark places match.</source>
        <translation>Nimmt langsame Helligkeitsänderungen aus den Farben, sodass Teile von hellen und dunklen Stellen zusammenpassen.</translation>
    </message>
    <message>
        <source>The colour axes that midway blending treats one by one.</source>
        <translation>Die Farbachsen, die Midway-Überblenden einzeln behandelt.</translation>
    </message>
    <message>
        <source>The edit &quot;{}&quot; says {} twice.</source>
        <translation>Die Bearbeitung „{}“ nennt {} zweimal.</translation>
    </message>
    <message>
        <source>The first image lies above, left of or outside the curve; circles go around the bottom right corner.</source>
        <translation>Das erste Bild liegt über, links von oder außerhalb der Kurve; Kreise laufen um die untere rechte Ecke.</translation>
    </message>
    <message>
        <source>The folder {} cannot be made; check that there is room.</source>
        <translation>Der Ordner {} kann nicht angelegt werden; prüfen Sie, ob Platz ist.</translation>
    </message>
    <message>
        <source>The input {} of {} takes a model of its own kind, and was given one of the kind {}.</source>
        <translation>Der Eingang {} von {} nimmt ein Modell seiner eigenen Art und bekam eines der Art {}.</translation>
    </message>
    <message>
        <source>The input {} of {} was given, and {} makes it, too; leave one of them out.</source>
        <translation>Der Eingang {} von {} wurde angegeben, und {} macht ihn auch; lassen Sie eines davon weg.</translation>
    </message>
    <message>
        <source>The model is of the kind {}; one of the kind {} is needed.</source>
        <translation>Das Modell ist von der Art {}; nötig ist eines von der Art {}.</translation>
    </message>
    <message>
        <source>The result has no output {}.</source>
        <translation>Das Ergebnis hat keinen Ausgang {}.</translation>
    </message>
    <message>
        <source>The {} says {} twice in one place; only one of them can hold.</source>
        <translation>{0}: {1} steht zweimal an einer Stelle; nur eines davon kann gelten.</translation>
    </message>
    <message>
        <source>The {} would replace {}, which Texloom did not write; name another file, or allow it with --overwrite.</source>
        <translation>{0} würde {1} ersetzen, das nicht von Texloom ist; nennen Sie eine andere Datei, oder erlauben Sie es mit --overwrite.</translation>
    </message>
    <message>
        <source>The {} {} and the {} {} are the same file; name another one.</source>
        <translation>{0} {1} und {2} {3} sind dieselbe Datei; nennen Sie eine andere.</translation>
    </message>
    <message>
        <source>There is no tool {}; the tools are {}.</source>
        <translation>Es gibt kein Werkzeug {}; die Werkzeuge sind {}.</translation>
    </message>
    <message>
        <source>There is not enough memory to take up an image: {}.</source>
        <translation>Der Speicher reicht nicht, um ein Bild aufzunehmen: {}.</translation>
    </message>
    <message>
        <source>There is nothing of the kind {}; there are {}.</source>
        <translation>Von der Art {} gibt es nichts; es gibt {}.</translation>
    </message>
    <message>
        <source>Top left</source>
        <translation>Oben links</translation>
    </message>
    <message>
        <source>Top right</source>
        <translation>Oben rechts</translation>
    </message>
    <message>
        <source>Top to bottom</source>
        <translation>Oben nach unten</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Drehen</translation>
    </message>
    <message>
        <source>Turn left by 90°</source>
        <translation>Um 90° nach links drehen</translation>
    </message>
    <message>
        <source>Turn right by 90°</source>
        <translation>Um 90° nach rechts drehen</translation>
    </message>
    <message>
        <source>Turns the exemplar clockwise. Quarter turns move pixels as they are; other angles keep the largest upright rectangle inside.</source>
        <translation>Dreht die Vorlage im Uhrzeigersinn. Vierteldrehungen verschieben Pixel unverändert; andere Winkel behalten das größte aufrechte Rechteck darin.</translation>
    </message>
    <message>
        <source>Vertical</source>
        <translation>Senkrecht</translation>
    </message>
    <message>
        <source>What the light is taken to be: what a wide window sees, or a low polynomial.</source>
        <translation>Wofür das Licht gehalten wird: was ein weites Fenster sieht, oder ein niedriges Polynom.</translation>
    </message>
    <message>
        <source>Where the curve lies, from 0 (top, left, the whole circle) to 1.</source>
        <translation>Wo die Kurve liegt, von 0 (oben, links, der ganze Kreis) bis 1.</translation>
    </message>
    <message>
        <source>Which sides change places.</source>
        <translation>Welche Seiten die Plätze tauschen.</translation>
    </message>
    <message>
        <source>Width of the window that finds the light, in shares of the shorter side: larger leaves more of the texture&apos;s own shades.</source>
        <translation>Breite des Fensters, das das Licht findet, als Anteil der kürzeren Seite: größer lässt mehr von den eigenen Tönen der Textur.</translation>
    </message>
    <message>
        <source>a profile</source>
        <translation>ein Profil</translation>
    </message>
    <message>
        <source>a source of the result</source>
        <translation>woraus das Ergebnis entsteht</translation>
    </message>
    <message>
        <source>bytes in hexadecimal</source>
        <translation>Bytes in hexadezimaler Schreibweise</translation>
    </message>
    <message>
        <source>bytes in hexadecimal, two digits each</source>
        <translation>Bytes in hexadezimaler Schreibweise, je zwei Ziffern</translation>
    </message>
    <message>
        <source>gamma {:.3g}</source>
        <translation>Gamma {:.3g}</translation>
    </message>
    <message>
        <source>gamma {:.3g} and primaries of its own</source>
        <translation>Gamma {:.3g} und eigene Primärfarben</translation>
    </message>
    <message>
        <source>primaries of its own</source>
        <translation>eigene Primärfarben</translation>
    </message>
    <message>
        <source>the codes {}-{}-{}-{} of cICP</source>
        <translation>die Kennzahlen {}-{}-{}-{} von cICP</translation>
    </message>
    <message>
        <source>text without a zero byte</source>
        <translation>Text ohne Nullbyte</translation>
    </message>
    <message>
        <source>the profile “{}”</source>
        <translation>das Profil „{}“</translation>
    </message>
    <message>
        <source>the {} that are free</source>
        <translation>die {}, die frei sind</translation>
    </message>
    <message>
        <source>the {} that it may take</source>
        <translation>die {}, die erlaubt sind</translation>
    </message>
    <message>
        <source>the {} that the limit of {} leaves</source>
        <translation>die {}, die die Grenze von {} übrig lässt</translation>
    </message>
    <message>
        <source>width,height, each {} to {} px</source>
        <translation>Breite,Höhe, je {} bis {} px</translation>
    </message>
    <message>
        <source>x,y,width,height in whole px</source>
        <translation>x,y,Breite,Höhe in ganzen px</translation>
    </message>
    <message>
        <source>{} = {}: this is no number in decimal digits, without spaces; {}: {}.</source>
        <translation>{} = {}: das ist keine Zahl in Dezimalziffern ohne Leerzeichen; {}: {}.</translation>
    </message>
    <message>
        <source>{} = {}: this is not a whole number; {}: {}.</source>
        <translation>{} = {}: das ist keine ganze Zahl; {}: {}.</translation>
    </message>
    <message>
        <source>{} = {}: this number is too large, or too near 0, to be held; {}: {}.</source>
        <translation>{} = {}: diese Zahl ist zu groß oder zu nahe an 0, um sich darstellen zu lassen; {}: {}.</translation>
    </message>
    <message>
        <source>{} cannot be read: its decoder broke down; the file is damaged, or of a kind that it does not know. Save it again with another program.</source>
        <translation>{} kann nicht gelesen werden: Der Decoder ist abgestürzt; die Datei ist beschädigt oder von einer Art, die er nicht kennt. Speichern Sie sie mit einem anderen Programm neu.</translation>
    </message>
    <message>
        <source>{} cannot be written: it is no ordinary file.</source>
        <translation>{} kann nicht geschrieben werden: Es ist keine gewöhnliche Datei.</translation>
    </message>
    <message>
        <source>{} carries {}, which Texloom cannot convert; its colours are taken as {}.</source>
        <translation>{} enthält {}, was Texloom nicht umrechnen kann; die Farben gelten als {}.</translation>
    </message>
    <message>
        <source>{} gives no output {}; it gives nothing beside its picture and map.</source>
        <translation>{} hat keinen Ausgang {}; außer Bild und Karte gibt es nichts.</translation>
    </message>
    <message>
        <source>{} gives no output {}; there are {}.</source>
        <translation>{} hat keinen Ausgang {}; es gibt {}.</translation>
    </message>
    <message>
        <source>{} has no layer {}; all that it holds is one picture.</source>
        <translation>{} hat keine Ebene {}; die Datei enthält nur ein einziges Bild.</translation>
    </message>
    <message>
        <source>{} has no layer {}; there is {}.</source>
        <translation>{} hat keine Ebene {}; es gibt {}.</translation>
    </message>
    <message>
        <source>{} has several parts: {}. Only {} is used; another can be chosen instead.</source>
        <translation>{} hat mehrere Teile: {}. Nur {} wird verwendet; stattdessen lässt sich ein anderer wählen.</translation>
    </message>
    <message>
        <source>{} has the layers {}; all its channels are used. One layer can be chosen instead.</source>
        <translation>{} hat die Ebenen {}; alle Kanäle werden verwendet. Stattdessen lässt sich eine Ebene wählen.</translation>
    </message>
    <message>
        <source>{} holds stray bytes, which were skipped.</source>
        <translation>{} enthält überzählige Bytes, die übergangen wurden.</translation>
    </message>
    <message>
        <source>{} holds whole numbers of 32 bits from {:.0f} to {:.0f}, which are taken as 0 to 1.</source>
        <translation>{} enthält ganze Zahlen zu 32 Bit von {:.0f} bis {:.0f}, die als 0 bis 1 gelten.</translation>
    </message>
    <message>
        <source>{} holds {} × {} px from ({}, {}) on, but is meant to show {} × {} px from ({}, {}) on; all that it holds is used.</source>
        <translation>{} enthält {} × {} px ab ({}, {}), soll aber {} × {} px ab ({}, {}) zeigen; verwendet wird alles, was die Datei enthält.</translation>
    </message>
    <message>
        <source>{} in the edit &quot;{}&quot;: write it as name=value.</source>
        <translation>{} in der Bearbeitung „{}“: schreiben Sie es als Name=Wert.</translation>
    </message>
    <message>
        <source>{} is a model of the kind {}; the input {} takes one of its own kind.</source>
        <translation>{} ist ein Modell der Art {}; der Eingang {} nimmt nur eines seiner eigenen Art.</translation>
    </message>
    <message>
        <source>{} is compressed with loss ({}), which moves the places that a map addresses; save it with zip, piz or none.</source>
        <translation>{} ist mit Verlust komprimiert ({}), was die Stellen verschiebt, auf die eine Karte zeigt; speichern Sie mit zip, piz oder none.</translation>
    </message>
    <message>
        <source>{} is in colours of its own ({}), which were converted.</source>
        <translation>{} ist in eigenen Farben ({}), die umgerechnet wurden.</translation>
    </message>
    <message>
        <source>{} is no tool that edits an exemplar; those are {}.</source>
        <translation>{} ist kein Werkzeug, das eine Vorlage bearbeitet; diese sind {}.</translation>
    </message>
    <message>
        <source>{} is {} × {} px with {} channels and takes {} of memory to read, more than {}; scale it down or cut it to size first.</source>
        <translation>{} hat {} × {} px mit {} Kanälen und braucht zum Lesen {} Speicher, mehr als {}; verkleinern oder beschneiden Sie das Bild zuerst.</translation>
    </message>
    <message>
        <source>{} numbers, {}</source>
        <translation>{} Zahlen, {}</translation>
    </message>
    <message>
        <source>{} points as x,y,x,y,… in px</source>
        <translation>{} Punkte als x,y,x,y,… in px</translation>
    </message>
    <message>
        <source>{} takes more memory to decode than there is.</source>
        <translation>{} braucht zum Decodieren mehr Speicher, als da ist.</translation>
    </message>
    <message>
        <source>{} takes too long to decode; save it again with another program.</source>
        <translation>{} braucht zu lange zum Decodieren; speichern Sie die Datei mit einem anderen Programm neu.</translation>
    </message>
    <message>
        <source>{} triangles</source>
        <translation>{} Dreiecke</translation>
    </message>
    <message>
        <source>{} was not there before; export again to see what would be replaced.</source>
        <translation>{} ist inzwischen dazugekommen; exportieren Sie neu, um zu sehen, was ersetzt würde.</translation>
    </message>
    <message>
        <source>{}, {}</source>
        <translation>{}, {}</translation>
    </message>
    <message>
        <source>{}: meshes are written as .ply.</source>
        <translation>{}: Netze werden als .ply geschrieben.</translation>
    </message>
    <message>
        <source>{}: {} is written as {}; give the file that extension.</source>
        <translation>{}: {} wird als {} geschrieben; geben Sie der Datei diese Endung.</translation>
    </message>
    <message>
        <source>↺ 90°</source>
        <translation>↺ 90°</translation>
    </message>
    <message>
        <source>↻ 90°</source>
        <translation>↻ 90°</translation>
    </message>
    <message>
        <source>{} cannot be read: its pixels are damaged, or packed in the old-style RLE of Radiance, which Texloom does not read. Save it again with another program.</source>
        <translation>{} kann nicht gelesen werden: Die Pixel sind beschädigt oder in der alten RLE-Art von Radiance gepackt, die Texloom nicht liest. Speichern Sie die Datei mit einem anderen Programm neu.</translation>
    </message>
    <message>
        <source>{} says it is {} × {} px, but has only {} bytes: it is cut short or damaged.</source>
        <translation>{} will {} × {} px haben, hat aber nur {} Bytes: Die Datei ist abgeschnitten oder beschädigt.</translation>
    </message>
    <message>
        <source>{} would be overwritten by the {} {}: it is {}; name another file.</source>
        <translation>{0} würde überschrieben ({1}: {2}), und es ist {3}; nennen Sie eine andere Datei.</translation>
    </message>
    <message>
        <source>{} would need {} of memory, more than {}; use smaller images.</source>
        <translation>{} bräuchte {} Speicher, mehr als {}; verwenden Sie kleinere Bilder.</translation>
    </message>
    <message>
        <source>Cost of all seams</source>
        <translation>Kosten aller Nähte</translation>
    </message>
    <message>
        <source>Entire patch</source>
        <translation>Ganze Vorlage</translation>
    </message>
    <message>
        <source>Graph cut</source>
        <translation>Graphenschnitt</translation>
    </message>
    <message>
        <source>How much worse than the best a place may fit and still be likely: larger varies more, smaller fits better.</source>
        <translation>Wie viel schlechter als die beste eine Stelle passen und noch wahrscheinlich sein darf: Größer variiert mehr, kleiner passt besser.</translation>
    </message>
    <message>
        <source>Lets seams cost less where the pictures change anyway, so that they follow edges.</source>
        <translation>Lässt Nähte dort weniger kosten, wo sich die Bilder ohnehin ändern, sodass sie Kanten folgen.</translation>
    </message>
    <message>
        <source>Mended seams</source>
        <translation>Ausgebesserte Nähte</translation>
    </message>
    <message>
        <source>Mending seams</source>
        <translation>Nähte ausbessern</translation>
    </message>
    <message>
        <source>Pastes the whole exemplar again and again, each time along the cheapest seam of any shape, and mends the worst seams at the end. Keeps objects such as stones and leaves whole; copies large areas verbatim.</source>
        <translation>Klebt die ganze Vorlage wieder und wieder auf, jedes Mal entlang der billigsten Naht beliebiger Form, und bessert am Ende die schlechtesten Nähte aus. Lässt Objekte wie Steine und Blätter ganz; kopiert große Flächen wörtlich.</translation>
    </message>
    <message>
        <source>Pasting along cuts</source>
        <translation>Entlang von Schnitten kleben</translation>
    </message>
    <message>
        <source>Placement</source>
        <translation>Platzierung</translation>
    </message>
    <message>
        <source>Random placement looks at nothing, so it cannot follow the initial image; choose entire or sub-patch.</source>
        <translation>Zufällige Platzierung sieht nichts an und kann dem Anfangsbild nicht folgen; wählen Sie „entire“ oder „sub-patch“.</translation>
    </message>
    <message>
        <source>Seam cost per pixel</source>
        <translation>Nahtkosten je Pixel</translation>
    </message>
    <message>
        <source>Seams along edges</source>
        <translation>Nähte entlang von Kanten</translation>
    </message>
    <message>
        <source>Side of the square that is compared for sub-patches and for mending: larger keeps larger structures whole.</source>
        <translation>Seite des Quadrats, das für Teilstücke und beim Ausbessern verglichen wird: Größer lässt größere Strukturen ganz.</translation>
    </message>
    <message>
        <source>So many times the worst seam is pasted over, where that makes it better: more takes longer and hides more.</source>
        <translation>So oft wird die schlechteste Naht überklebt, wo das besser ist: Mehr dauert länger und verdeckt mehr.</translation>
    </message>
    <message>
        <source>Sub-patch</source>
        <translation>Teilstück</translation>
    </message>
    <message>
        <source>The mask hides all of the exemplar; leave at least 1 px to copy.</source>
        <translation>Die Maske verdeckt die ganze Vorlage; lassen Sie mindestens 1 px zum Kopieren frei.</translation>
    </message>
    <message>
        <source>Where the exemplar is pasted next: anywhere, where all of it fits what is there, or where a square of it does, which suits what has no clear structure.</source>
        <translation>Wo die Vorlage als Nächstes aufgeklebt wird: irgendwo, dort, wo sie ganz zum Vorhandenen passt, oder dort, wo ein Quadrat von ihr passt, was für Texturen ohne klare Struktur gut ist.</translation>
    </message>
    <message>
        <source>{} is {} × {} px, smaller than the compared square of {} px; choose one of at most {} px.</source>
        <translation>{} hat {} × {} px, weniger als das verglichene Quadrat von {} px; wählen Sie eines von höchstens {} px.</translation>
    </message>
    <message>
        <source>A picture of the result&apos;s size whose shapes the exemplar takes on.</source>
        <translation>Ein Bild von der Größe des Ergebnisses, dessen Formen die Vorlage annimmt.</translation>
    </message>
    <message>
        <source>A tree finds a neighbourhood that is nearly the nearest, in time that hardly grows with the exemplar; exact compares all of them.</source>
        <translation>Ein Baum findet eine Umgebung, die fast die nächste ist, in einer Zeit, die mit der Vorlage kaum wächst; exakt vergleicht alle.</translation>
    </message>
    <message>
        <source>Ashikhmin</source>
        <translation>Ashikhmin</translation>
    </message>
    <message>
        <source>At most so many waves, the strongest: more follow finer regularity and take longer.</source>
        <translation>Höchstens so viele Wellen, die stärksten: mehr folgen feinerer Regelmäßigkeit und dauern länger.</translation>
    </message>
    <message>
        <source>At most so many, each half the size of the one before: more keep larger structures.</source>
        <translation>Höchstens so viele, jede halb so groß wie die vorige: mehr erhalten größere Strukturen.</translation>
    </message>
    <message>
        <source>Coherence</source>
        <translation>Zusammenhang</translation>
    </message>
    <message>
        <source>Components</source>
        <translation>Komponenten</translation>
    </message>
    <message>
        <source>Copying pixels one by one</source>
        <translation>Pixel werden einzeln kopiert</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Drawing the regular part</source>
        <translation>Der regelmäßige Teil wird gezeichnet</translation>
    </message>
    <message>
        <source>Drift over the output, in cycles</source>
        <translation>Abweichung über die Ausgabe, in Perioden</translation>
    </message>
    <message>
        <source>Efros–Leung</source>
        <translation>Efros–Leung</translation>
    </message>
    <message>
        <source>Finding waves</source>
        <translation>Wellen werden gesucht</translation>
    </message>
    <message>
        <source>Finding what looks alike</source>
        <translation>Ähnliches wird gesucht</translation>
    </message>
    <message>
        <source>Finds out once which places of the exemplar look alike, and then walks through it, jumping between them. The fastest of the methods that work pixel by pixel; joins are rougher than Ashikhmin&apos;s.</source>
        <translation>Findet einmal heraus, welche Stellen der Vorlage sich gleichen, und durchwandert sie dann mit Sprüngen zwischen ihnen. Das schnellste der Verfahren, die Pixel für Pixel arbeiten; Nähte sind rauer als bei Ashikhmin.</translation>
    </message>
    <message>
        <source>Finds the waves that a near-regular exemplar is made of, to a fraction of a cycle, continues them over the output, and quilts patches that follow them. Suits weaves, bricks and tiles that are seen straight on.</source>
        <translation>Findet die Wellen, aus denen eine fast regelmäßige Vorlage besteht, auf den Bruchteil einer Periode genau, setzt sie über die Ausgabe fort und fügt Patches aneinander, die ihnen folgen. Gut für Gewebe, Ziegel und Fliesen, die gerade von vorn zu sehen sind.</translation>
    </message>
    <message>
        <source>Fourier mask</source>
        <translation>Fourier-Maske</translation>
    </message>
    <message>
        <source>Growing pixels</source>
        <translation>Pixel wachsen</translation>
    </message>
    <message>
        <source>Grows outwards from what is known, layer by layer, or row by row from the top left.</source>
        <translation>Wächst von dem, was bekannt ist, Schicht um Schicht nach außen, oder Zeile um Zeile von links oben.</translation>
    </message>
    <message>
        <source>How closely the target is followed, if there is one: larger follows it more, smaller keeps more of the exemplar&apos;s structure.</source>
        <translation>Wie genau dem Ziel gefolgt wird, falls es eines gibt: größer folgt ihm mehr, kleiner hält sich mehr an die Struktur der Vorlage.</translation>
    </message>
    <message>
        <source>How far from its own place in an exemplar of the output&apos;s size a pixel&apos;s source may lie, as in a photo that is mended: smaller takes what is near, and is faster; 0 looks everywhere.</source>
        <translation>Wie weit die Quelle eines Pixels von seiner eigenen Stelle in einer Vorlage von der Größe der Ausgabe entfernt sein darf, etwa in einem Foto, das ausgebessert wird: kleiner nimmt, was nahe liegt, und ist schneller; 0 sucht überall.</translation>
    </message>
    <message>
        <source>How far from the middle pixels of the window count, as a share of the window: larger looks further, smaller trusts the nearest.</source>
        <translation>Wie weit von der Mitte Pixel des Fensters zählen, als Anteil des Fensters: größer blickt weiter, kleiner vertraut den nächsten.</translation>
    </message>
    <message>
        <source>How far these lie from the pixel and from each other at least: larger leads to more different parts of the exemplar.</source>
        <translation>Wie weit diese mindestens vom Pixel und voneinander entfernt liegen: größer führt in verschiedenere Teile der Vorlage.</translation>
    </message>
    <message>
        <source>How likely a random pixel of the exemplar may be chosen too: larger varies more and copies smaller pieces.</source>
        <translation>Wie wahrscheinlich auch ein zufälliges Pixel der Vorlage zur Wahl steht: größer variiert mehr und kopiert kleinere Stücke.</translation>
    </message>
    <message>
        <source>How likely a walk jumps where another place looks the same: larger copies smaller pieces.</source>
        <translation>Wie wahrscheinlich gesprungen wird, wo eine andere Stelle gleich aussieht: größer kopiert kleinere Stücke.</translation>
    </message>
    <message>
        <source>How much pictures A and B count beside the exemplar: larger follows them more closely.</source>
        <translation>Wie viel die Bilder A und B neben der Vorlage zählen: größer folgt ihnen genauer.</translation>
    </message>
    <message>
        <source>How much the regular part counts beside the fit of overlaps: larger keeps the order, 0 quilts without it.</source>
        <translation>Wie viel der regelmäßige Teil neben der Passung der Überlappungen zählt: mehr hält die Ordnung, 0 quiltet ohne ihn.</translation>
    </message>
    <message>
        <source>How much worse a pixel may fit that continues the copy beside it: larger copies larger pieces, 0 takes whatever fits best.</source>
        <translation>Wie viel schlechter ein Pixel passen darf, das die Kopie daneben fortsetzt: größer kopiert größere Stücke, 0 nimmt, was am besten passt.</translation>
    </message>
    <message>
        <source>How much worse than the best a window may fit and still be drawn: larger varies more, smaller copies longer stretches.</source>
        <translation>Wie viel schlechter als das beste ein Fenster passen und doch gezogen werden darf: größer variiert mehr, kleiner kopiert längere Strecken.</translation>
    </message>
    <message>
        <source>How often each scale is made: passes after the first see all that surrounds a pixel, which repairs seams.</source>
        <translation>Wie oft jede Skala gemacht wird: Durchgänge nach dem ersten sehen alles, was ein Pixel umgibt, und bessern Nähte aus.</translation>
    </message>
    <message>
        <source>How often the output is gone through: passes after the first see all that surrounds a pixel, which repairs seams.</source>
        <translation>Wie oft das Ergebnis durchlaufen wird: Durchgänge nach dem ersten sehen alles, was ein Pixel umgibt, und bessern Nähte aus.</translation>
    </message>
    <message>
        <source>Image analogies</source>
        <translation>Bildanalogien</translation>
    </message>
    <message>
        <source>Jump</source>
        <translation>Sprung</translation>
    </message>
    <message>
        <source>Jump map</source>
        <translation>Sprungkarte</translation>
    </message>
    <message>
        <source>Jump probability</source>
        <translation>Sprungwahrscheinlichkeit</translation>
    </message>
    <message>
        <source>Jumps</source>
        <translation>Sprünge</translation>
    </message>
    <message>
        <source>Known</source>
        <translation>Bekannt</translation>
    </message>
    <message>
        <source>Largest move to close, in cycles</source>
        <translation>Größte Verschiebung zum Schließen, in Perioden</translation>
    </message>
    <message>
        <source>Leaf</source>
        <translation>Blatt</translation>
    </message>
    <message>
        <source>Makes one pixel after another in rows, from coarse to fine, and takes each from where the exemplar looks most like what is there above and to the left. Always tiles from left to right; small details may become blurred.</source>
        <translation>Macht zeilenweise ein Pixel nach dem anderen, von grob nach fein, und nimmt jedes von dort, wo die Vorlage dem am meisten gleicht, was darüber und links davon steht. Kachelt von links nach rechts immer; kleine Einzelheiten können verschwimmen.</translation>
    </message>
    <message>
        <source>Makes one pixel after another in rows; each continues one of the copies that its neighbours belong to, so that pieces of the exemplar grow until they meet. Very fast, and at its best on natural textures such as grass, leaves and pebbles.</source>
        <translation>Macht zeilenweise ein Pixel nach dem anderen; jedes setzt eine der Kopien fort, zu denen seine Nachbarn gehören, sodass Stücke der Vorlage wachsen, bis sie sich treffen. Sehr schnell und am besten bei natürlichen Texturen wie Gras, Laub und Kies.</translation>
    </message>
    <message>
        <source>Makes what stands to picture B as the exemplar stands to picture A: paint the exemplar&apos;s materials as flat colours in A, and where they are to be in B. Without the pictures it makes more of the exemplar.</source>
        <translation>Macht, was sich zu Bild B verhält wie die Vorlage zu Bild A: Malen Sie in A flache Farben für die Materialien der Vorlage und in B, wo sie sein sollen, und das Ergebnis hat diese Materialien dort. Ohne die Bilder macht es mehr von der Vorlage.</translation>
    </message>
    <message>
        <source>Mean distance of the neighbourhoods</source>
        <translation>Mittlerer Abstand der Umgebungen</translation>
    </message>
    <message>
        <source>Neighbourhoods in a leaf of the tree: larger finds nearer ones, but takes longer.</source>
        <translation>Umgebungen in einem Blatt des Baums: größer findet nähere, dauert aber länger.</translation>
    </message>
    <message>
        <source>Onion</source>
        <translation>Zwiebel</translation>
    </message>
    <message>
        <source>Only {:.1f} % of {} is regular, less than {:.0f} %, so hardly anything guides the patches; lower the threshold, or use image quilting.</source>
        <translation>Nur {} % von {} sind regelmäßig, weniger als {} %, sodass die Patches kaum geführt werden; senken Sie die Schwelle, oder nehmen Sie das Bild-Quilting.</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Reihenfolge</translation>
    </message>
    <message>
        <source>Parent square</source>
        <translation>Elternquadrat</translation>
    </message>
    <message>
        <source>Peaks of the spectrum this high, over the highest, count as waves: smaller finds more of them, and takes chance for rule.</source>
        <translation>So hohe Spitzen des Spektrums, gemessen an der höchsten, zählen als Wellen: weniger findet mehr und hält Zufall für Regel.</translation>
    </message>
    <message>
        <source>Picture A</source>
        <translation>Bild A</translation>
    </message>
    <message>
        <source>Picture B</source>
        <translation>Bild B</translation>
    </message>
    <message>
        <source>Picture B has the colour {}, which picture A has nowhere; paint it in A, too, or use A&apos;s colours: {}.</source>
        <translation>Bild B hat die Farbe {}, die Bild A nirgends hat; malen Sie sie auch in A, oder nehmen Sie die Farben von A: {}.</translation>
    </message>
    <message>
        <source>Places that are kept for each pixel of the exemplar because they look like it: more vary more.</source>
        <translation>Stellen, die für jedes Pixel der Vorlage behalten werden, weil sie ihm gleichen: mehr variieren mehr.</translation>
    </message>
    <message>
        <source>Principal components</source>
        <translation>Hauptkomponenten</translation>
    </message>
    <message>
        <source>Principal components by which likely windows are found: more find nearer ones, but take longer.</source>
        <translation>Hauptkomponenten, nach denen wahrscheinliche Fenster gefunden werden: mehr finden nähere, dauern aber länger.</translation>
    </message>
    <message>
        <source>Regular part</source>
        <translation>Regelmäßiger Teil</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>Zeilen</translation>
    </message>
    <message>
        <source>Search radius</source>
        <translation>Suchradius</translation>
    </message>
    <message>
        <source>Seed size</source>
        <translation>Größe des Keims</translation>
    </message>
    <message>
        <source>Share of the variance in the regular part</source>
        <translation>Anteil der Varianz im regelmäßigen Teil</translation>
    </message>
    <message>
        <source>Side of the square of the exemplar that growth begins with, at most the window: larger begins with more structure.</source>
        <translation>Seite des Quadrats der Vorlage, mit dem das Wachstum beginnt, höchstens das Fenster: größer beginnt mit mehr Struktur.</translation>
    </message>
    <message>
        <source>Side of the square that is compared (an even one counts as the next odd): larger keeps larger structures, but takes longer.</source>
        <translation>Seite des Quadrats, das verglichen wird (eine gerade zählt als die nächste ungerade): größer erhält größere Strukturen, dauert aber länger.</translation>
    </message>
    <message>
        <source>Side of the square that is compared (an even one counts as the next odd): too small grows garbage, too large copies verbatim.</source>
        <translation>Seite des Quadrats, das verglichen wird (eine gerade zählt als die nächste ungerade): zu klein lässt Unsinn wachsen, zu groß kopiert wörtlich.</translation>
    </message>
    <message>
        <source>Side of the square that is compared on the next coarser scale (an even one counts as the next odd): larger follows the coarser scale more closely; 0 forgets it.</source>
        <translation>Seite des Quadrats, das auf der nächstgröberen Skala verglichen wird (eine gerade zählt als die nächste ungerade): größer folgt der gröberen Skala genauer; 0 vergisst sie.</translation>
    </message>
    <message>
        <source>Side of the square whose known half is compared (an even one counts as the next odd): larger keeps larger structures, but takes longer and copies more.</source>
        <translation>Seite des Quadrats, dessen bekannte Hälfte verglichen wird (eine gerade zählt als die nächste ungerade): größer erhält größere Strukturen, dauert aber länger und kopiert mehr.</translation>
    </message>
    <message>
        <source>Side of the squares by which places look alike (an even one counts as the next odd): larger jumps only where larger structures agree.</source>
        <translation>Seite der Quadrate, nach denen Stellen sich gleichen (eine gerade zählt als die nächste ungerade): größer springt nur, wo größere Strukturen übereinstimmen.</translation>
    </message>
    <message>
        <source>Side of the squares that are copied: larger keeps larger structures whole, smaller follows the waves more closely.</source>
        <translation>Seite der kopierten Quadrate: größere halten größere Strukturen zusammen, kleinere folgen den Wellen genauer.</translation>
    </message>
    <message>
        <source>Sigma</source>
        <translation>Sigma</translation>
    </message>
    <message>
        <source>Target weight</source>
        <translation>Gewicht des Ziels</translation>
    </message>
    <message>
        <source>There is a mask of what is known, but no image to start from; give that too.</source>
        <translation>Es gibt eine Maske dessen, was bekannt ist, aber kein Ausgangsbild; geben Sie auch dieses.</translation>
    </message>
    <message>
        <source>There is a picture B, but {} has no picture A; give both, or none.</source>
        <translation>Es gibt ein Bild B, aber {} hat kein Bild A; geben Sie beide oder keines.</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>Schwelle</translation>
    </message>
    <message>
        <source>Tree</source>
        <translation>Baum</translation>
    </message>
    <message>
        <source>Walking through the exemplar</source>
        <translation>Die Vorlage wird durchwandert</translation>
    </message>
    <message>
        <source>Waves</source>
        <translation>Wellen</translation>
    </message>
    <message>
        <source>Weight of A and B</source>
        <translation>Gewicht von A und B</translation>
    </message>
    <message>
        <source>Weight of the waves</source>
        <translation>Gewicht der Wellen</translation>
    </message>
    <message>
        <source>Wei–Levoy</source>
        <translation>Wei–Levoy</translation>
    </message>
    <message>
        <source>Nothing says what to keep of the image to start from; give a mask of what is known.</source>
        <translation>Was vom Ausgangsbild bleiben soll, ist nicht gesagt; geben Sie eine Maske dessen, was bekannt ist.</translation>
    </message>
    <message>
        <source>What of the image to start from is kept; the rest, where it is black, is made again.</source>
        <translation>Was vom Ausgangsbild bleibt; der Rest, wo sie schwarz ist, wird neu gemacht.</translation>
    </message>
    <message>
        <source>What the exemplar is made of, pixel for pixel: flat colours for its materials, or the picture before a filter made the exemplar of it.</source>
        <translation>Woraus die Vorlage besteht, Pixel für Pixel: flache Farben für ihre Materialien, oder das Bild, bevor ein Filter die Vorlage daraus machte.</translation>
    </message>
    <message>
        <source>What the result is to be made of, in the colours of picture A.</source>
        <translation>Woraus das Ergebnis bestehen soll, in den Farben von Bild A.</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>{} has a picture A, but there is no picture B; give both, or none.</source>
        <translation>{} hat ein Bild A, aber es gibt kein Bild B; geben Sie beide oder keines.</translation>
    </message>
    <message>
        <source>{} is {} × {} px, smaller than the neighbourhood of {} px; choose a neighbourhood of at most {} px, or a larger exemplar.</source>
        <translation>{} ist {} × {} px groß, kleiner als die Umgebung von {} px; wählen Sie eine Umgebung von höchstens {} px oder eine größere Vorlage.</translation>
    </message>
    <message>
        <source>{} is not the file any more that the result was made from.</source>
        <translation>{} ist nicht mehr die Datei, aus der das Ergebnis gemacht wurde.</translation>
    </message>
    <message>
        <source>+ cuts</source>
        <translation>+ Schnitte</translation>
    </message>
    <message>
        <source>+ frequencies of atoms</source>
        <translation>+ Häufigkeiten der Atome</translation>
    </message>
    <message>
        <source>+ low frequencies: all of it</source>
        <translation>+ tiefe Frequenzen: alles</translation>
    </message>
    <message>
        <source>+ scales</source>
        <translation>+ Skalen</translation>
    </message>
    <message>
        <source>A hole has no overlaps of even width to blend; choose the stitch cut, smooth-cut, none or poisson.</source>
        <translation>Ein Loch hat keine gleich breiten Überlappungen, die sich mischen ließen; wählen Sie die Naht cut, smooth-cut, none oder poisson.</translation>
    </message>
    <message>
        <source>A learnt dictionary of this exemplar, so that none is learned again.</source>
        <translation>Ein gelerntes Wörterbuch dieser Vorlage, damit keines neu gelernt wird.</translation>
    </message>
    <message>
        <source>A patch of {} px has {} values, so that it cannot have {} atoms; choose at most {}.</source>
        <translation>Ein Patch von {} px hat {} Werte und kann deshalb nicht {} Atome haben; wählen Sie höchstens {}.</translation>
    </message>
    <message>
        <source>Across</source>
        <translation>Quer</translation>
    </message>
    <message>
        <source>Affine in two pieces</source>
        <translation>Affin in zwei Stücken</translation>
    </message>
    <message>
        <source>All constraints of Tartavel, Gousseau and Peyré with their numbers, at the exemplar&apos;s size with its own low frequencies.</source>
        <translation>Alle Bedingungen von Tartavel, Gousseau und Peyré mit ihren Zahlen, in der Größe der Vorlage mit deren eigenen tiefen Frequenzen.</translation>
    </message>
    <message>
        <source>All tiles alike</source>
        <translation>Alle Kacheln gleich</translation>
    </message>
    <message>
        <source>All tiles alike are copies of one; varied ones differ as the exemplar&apos;s tiles differ from their mean, and are a little softer.</source>
        <translation>Gleiche Kacheln sind Kopien einer einzigen; verschiedene weichen ab wie die der Vorlage von ihrem Mittel und sind etwas weicher.</translation>
    </message>
    <message>
        <source>Along which axes colours are distributed as in the exemplar: principal axes keep how channels go together.</source>
        <translation>Entlang welcher Achsen die Farben wie in der Vorlage verteilt sind: Hauptachsen erhalten den Zusammenhang der Kanäle.</translation>
    </message>
    <message>
        <source>Amplitude</source>
        <translation>Amplitude</translation>
    </message>
    <message>
        <source>An amplitude of {} would fold the picture; it was lowered to {:.3f}, the most that surely does not.</source>
        <translation>Eine Amplitude von {} würde das Bild falten; sie wurde auf {:.3f} gesenkt, das Größte, das es sicher nicht tut.</translation>
    </message>
    <message>
        <source>Anamorphosis</source>
        <translation>Anamorphose</translation>
    </message>
    <message>
        <source>Ashikhmin: pieces that grow</source>
        <translation>Ashikhmin: Stücke, die wachsen</translation>
    </message>
    <message>
        <source>At scale 1/{} there are {} patches to learn from, so that the dictionary has {} atoms instead of {}.</source>
        <translation>Auf der Skala 1/{} gibt es {} Patches zum Lernen, so dass das Wörterbuch {} Atome statt {} hat.</translation>
    </message>
    <message>
        <source>Atoms</source>
        <translation>Atome</translation>
    </message>
    <message>
        <source>Atoms describe how patches differ from the exemplar&apos;s mean colour, rather than from black, as published: of use for maps with values far from 0, and blurrier for pictures.</source>
        <translation>Atome beschreiben, wie Patches von der mittleren Farbe der Vorlage abweichen statt von Schwarz, wie veröffentlicht: nützlich für Karten mit Werten weit von 0, für Bilder unschärfer.</translation>
    </message>
    <message>
        <source>Atoms in use</source>
        <translation>Benutzte Atome</translation>
    </message>
    <message>
        <source>Atoms of a patch</source>
        <translation>Atome eines Patches</translation>
    </message>
    <message>
        <source>Atoms of the dictionary at each scale: more tell more features apart, and take longer to learn.</source>
        <translation>Atome des Wörterbuchs auf jeder Skala: mehr unterscheiden mehr Merkmale und brauchen länger zum Lernen.</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>Basic (Peyré 2009)</source>
        <translation>Grundform (Peyré 2009)</translation>
    </message>
    <message>
        <source>Between pixels: cubic is sharpest, linear never overshoots, the nearest pixel is copied as it is.</source>
        <translation>Zwischen Pixeln: Kubisch ist am schärfsten, linear schwingt nie über, das nächste Pixel wird kopiert, wie es ist.</translation>
    </message>
    <message>
        <source>Beyond the border</source>
        <translation>Jenseits des Randes</translation>
    </message>
    <message>
        <source>Blocks</source>
        <translation>Blöcke</translation>
    </message>
    <message>
        <source>Blocks are drawn at random along the lattice and make new tiles of parts of several; whole tiles are stitched one after another, each to fit those before.</source>
        <translation>Blöcke werden entlang des Gitters zufällig gezogen und bilden neue Kacheln aus Teilen mehrerer; ganze Kacheln werden eine nach der anderen angefügt, jede passend zu den vorigen.</translation>
    </message>
    <message>
        <source>Both ways</source>
        <translation>In beide Richtungen</translation>
    </message>
    <message>
        <source>Chaos</source>
        <translation>Chaos</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>Spalten</translation>
    </message>
    <message>
        <source>Context</source>
        <translation>Umgebung</translation>
    </message>
    <message>
        <source>Cubic</source>
        <translation>Kubisch</translation>
    </message>
    <message>
        <source>Curve of the map</source>
        <translation>Kurve der Karte</translation>
    </message>
    <message>
        <source>Cuts</source>
        <translation>Schnitte</translation>
    </message>
    <message>
        <source>Cuts the exemplars into pieces, shuffles them so that each is used once, and levels the joints. Keeps large natural textures such as stone and metal from repeating; long structures across pieces are lost.</source>
        <translation>Zerschneidet die Vorlagen in Stücke, mischt sie so, dass jedes einmal vorkommt, und gleicht die Fugen aus. So wiederholen sich große natürliche Texturen wie Stein und Metall nicht; lange Strukturen über Stücke hinweg gehen verloren.</translation>
    </message>
    <message>
        <source>Deforming</source>
        <translation>Verformen</translation>
    </message>
    <message>
        <source>Deforms the exemplar, or what another method made of it, lightly and without folds: stretched along one axis, or as if seen through hot air. Hides repetitions a little; what is salient is still known again.</source>
        <translation>Verformt die Vorlage, oder was ein anderes Verfahren aus ihr gemacht hat, leicht und ohne Falten: entlang einer Achse gestreckt oder wie durch heiße Luft gesehen. Verbirgt Wiederholungen ein wenig; Auffälliges erkennt man wieder.</translation>
    </message>
    <message>
        <source>Dictionary</source>
        <translation>Wörterbuch</translation>
    </message>
    <message>
        <source>Dictionary at scale 1/{}</source>
        <translation>Wörterbuch auf der Skala 1/{}</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Abwärts</translation>
    </message>
    <message>
        <source>Drawing the deformation</source>
        <translation>Verformung ziehen</translation>
    </message>
    <message>
        <source>Drawn</source>
        <translation>Ziehung</translation>
    </message>
    <message>
        <source>Draws the colours towards the exemplar&apos;s distribution.</source>
        <translation>Zieht die Farben zur Verteilung der Vorlage hin.</translation>
    </message>
    <message>
        <source>Draws the image towards the exemplar&apos;s Fourier spectrum: brings fine grain back, which few atoms cannot code.</source>
        <translation>Zieht das Bild zum Fourier-Spektrum der Vorlage hin: bringt feine Körnung zurück, die wenige Atome nicht darstellen können.</translation>
    </message>
    <message>
        <source>Draws what is larger than a patch towards a target, so that no large blotches arise.</source>
        <translation>Zieht alles, was größer als ein Patch ist, zu einem Ziel hin, damit keine großen Flecken entstehen.</translation>
    </message>
    <message>
        <source>Efros–Leung: the window</source>
        <translation>Efros–Leung: das Fenster</translation>
    </message>
    <message>
        <source>Energy</source>
        <translation>Energie</translation>
    </message>
    <message>
        <source>Energy of a pixel</source>
        <translation>Energie eines Pixels</translation>
    </message>
    <message>
        <source>Every tile by itself, in the order of the table.</source>
        <translation>Jede Kachel für sich, in der Reihenfolge der Tabelle.</translation>
    </message>
    <message>
        <source>Feather</source>
        <translation>Überblenden</translation>
    </message>
    <message>
        <source>Figure 2 of Tartavel, Gousseau and Peyré: Heeger–Bergen, Portilla–Simoncelli, sparse synthesis, and Peyré&apos;s method of 2009.</source>
        <translation>Abbildung 2 von Tartavel, Gousseau und Peyré: Heeger–Bergen, Portilla–Simoncelli, dünn besetzte Synthese und Peyrés Verfahren von 2009.</translation>
    </message>
    <message>
        <source>Figure 4 of Tartavel, Gousseau and Peyré: from Peyré&apos;s method of 2009, each run adds one constraint to those before it.</source>
        <translation>Abbildung 4 von Tartavel, Gousseau und Peyré: ausgehend von Peyrés Verfahren von 2009 fügt jeder Lauf den vorigen eine Bedingung hinzu.</translation>
    </message>
    <message>
        <source>Flips pieces and turns them by 180° at random: varies more, but light then comes from several sides, also in companion normal maps.</source>
        <translation>Spiegelt Stücke und dreht sie um 180°, zufällig: mehr Abwechslung, aber das Licht kommt dann von mehreren Seiten, auch in begleitenden Normalenkarten.</translation>
    </message>
    <message>
        <source>For outputs larger than the exemplar: low frequencies of random phases, lightly held, and one scale more.</source>
        <translation>Für Ausgaben, die größer als die Vorlage sind: tiefe Frequenzen mit Zufallsphasen, leicht gewichtet, und eine Skala mehr.</translation>
    </message>
    <message>
        <source>Frequencies of atoms</source>
        <translation>Häufigkeiten der Atome</translation>
    </message>
    <message>
        <source>From one patch that is learnt from to the next: wider steps in a small exemplar leave so few patches that the atoms merely repeat them. At most 20 patches for each atom are used.</source>
        <translation>Von einem Patch, aus dem gelernt wird, zum nächsten: weite Schritte lassen in einer kleinen Vorlage so wenige Patches, dass die Atome sie nur wiederholen. Höchstens 20 Patches je Atom werden benutzt.</translation>
    </message>
    <message>
        <source>From one patch to the next, at most the patch size: closer is surer and takes longer; half the patch is published.</source>
        <translation>Von einem Patch zum nächsten, höchstens die Patchgröße: enger ist sicherer und dauert länger; veröffentlicht ist der halbe Patch.</translation>
    </message>
    <message>
        <source>From the exemplar’s tiles</source>
        <translation>Aus den Kacheln der Vorlage</translation>
    </message>
    <message>
        <source>From the mean</source>
        <translation>Vom Mittelwert aus</translation>
    </message>
    <message>
        <source>Gradient steps</source>
        <translation>Gradientenschritte</translation>
    </message>
    <message>
        <source>Histogram</source>
        <translation>Histogramm</translation>
    </message>
    <message>
        <source>How a patch is joined to its neighbours: a cut, or none, keeps every pixel as it is in the exemplar; the others blend where patches overlap.</source>
        <translation>Wie ein Flicken mit seinen Nachbarn verbunden wird: Ein Schnitt, oder keiner, lässt jedes Pixel, wie es in der Vorlage ist; die anderen mischen, wo Flicken sich überlappen.</translation>
    </message>
    <message>
        <source>How far from a joint levels are drawn together, in sides of a piece: larger hides joints over more of a piece, and lets shades drift; 0 levels without limit.</source>
        <translation>Wie weit von einer Fuge die Helligkeiten angeglichen werden, in Stückseiten: Größer verbirgt Fugen über mehr von einem Stück und lässt Schattierungen wandern; 0 gleicht unbegrenzt aus.</translation>
    </message>
    <message>
        <source>How far into each other neighbouring tiles fade, up to half a tile: more hides their edges, less is sharper.</source>
        <translation>Wie weit benachbarte Kacheln ineinander übergehen, bis zu einer halben Kachel: mehr verbirgt ihre Ränder, weniger ist schärfer.</translation>
    </message>
    <message>
        <source>How many atoms make up a patch: more follow the exemplar more closely, fewer keep edges clean.</source>
        <translation>Aus wie vielen Atomen ein Patch besteht: mehr folgen der Vorlage genauer, weniger halten Kanten sauber.</translation>
    </message>
    <message>
        <source>How much a patch that is used too often is avoided: larger shows all of the exemplar, 0 takes whatever fits best, as a hole does that is filled.</source>
        <translation>Wie sehr ein zu oft verwendeter Flicken gemieden wird: Größer zeigt die ganze Vorlage, 0 nimmt, was am besten passt, wie ein Loch, das gefüllt wird.</translation>
    </message>
    <message>
        <source>How much of each component a tile gets: normally distributed, which makes what the exemplar does not show, or as much as some tile of the exemplar has.</source>
        <translation>Wie viel eine Kachel von jeder Komponente erhält: normalverteilt, was auch ergibt, was die Vorlage nicht zeigt, oder so viel wie irgendeine Kachel der Vorlage.</translation>
    </message>
    <message>
        <source>How much the distribution of colours counts against the patches.</source>
        <translation>Wie viel die Verteilung der Farben gegenüber den Patches zählt.</translation>
    </message>
    <message>
        <source>How much the low frequencies count against the patches.</source>
        <translation>Wie viel die tiefen Frequenzen gegenüber den Patches zählen.</translation>
    </message>
    <message>
        <source>How much the spectrum counts against the patches.</source>
        <translation>Wie viel das Spektrum gegenüber den Patches zählt.</translation>
    </message>
    <message>
        <source>How overlapping patches are put together: joined along cuts, which is sharp, or averaged, which blurs.</source>
        <translation>Wie überlappende Patches zusammengesetzt werden: entlang von Schnitten, was scharf ist, oder gemittelt, was verwischt.</translation>
    </message>
    <message>
        <source>How strongly: 0 changes nothing; near 1 the most squeezed places shrink to almost nothing. Turbulence is lowered until nothing folds.</source>
        <translation>Wie stark: 0 ändert nichts; nahe 1 schrumpfen die am stärksten gestauchten Stellen fast auf nichts. Turbulenz wird gesenkt, bis sich nichts faltet.</translation>
    </message>
    <message>
        <source>How the exemplar goes on where the output is larger or wraps: mirrored it joins with itself; repeat one that tiles.</source>
        <translation>Wie die Vorlage weitergeht, wo die Ausgabe größer ist oder sich schließt: Gespiegelt passt sie an sich selbst; wiederholen Sie eine, die kachelt.</translation>
    </message>
    <message>
        <source>Image analogies with painted pictures: A says where the exemplar&apos;s stones and gaps are, B where they are to be; the two count more from run to run.</source>
        <translation>Bildanalogien mit gemalten Bildern: A sagt, wo in der Vorlage Steine und Fugen sind, B, wo sie hin sollen; beide zählen von Lauf zu Lauf mehr.</translation>
    </message>
    <message>
        <source>In how many principal components tiles vary, at most: more show finer differences, 0 repeats the mean tile.</source>
        <translation>In höchstens so vielen Hauptkomponenten unterscheiden sich Kacheln: mehr zeigen feinere Unterschiede, 0 wiederholt die mittlere Kachel.</translation>
    </message>
    <message>
        <source>Interpolation</source>
        <translation>Interpolation</translation>
    </message>
    <message>
        <source>K-SVD</source>
        <translation>K-SVD</translation>
    </message>
    <message>
        <source>K-SVD improves every atom for all patches that use it, and learns better; online learning looks at few patches at a time.</source>
        <translation>K-SVD verbessert jedes Atom für alle Patches, die es benutzen, und lernt besser; fortlaufendes Lernen sieht wenige Patches auf einmal an.</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Laying pieces</source>
        <translation>Stücke legen</translation>
    </message>
    <message>
        <source>Learning</source>
        <translation>Lernen</translation>
    </message>
    <message>
        <source>Learning at scale 1/{}</source>
        <translation>Lernen auf der Skala 1/{}</translation>
    </message>
    <message>
        <source>Learning rounds</source>
        <translation>Lernrunden</translation>
    </message>
    <message>
        <source>Learning step</source>
        <translation>Lernschritt</translation>
    </message>
    <message>
        <source>Learns atoms of which a few make up any patch of the exemplar, and shows them, those used most first. Sparse synthesis takes the dictionary up, so that it is learnt only once.</source>
        <translation>Lernt Atome, von denen wenige jeden Patch der Vorlage ergeben, und zeigt sie, die meistbenutzten zuerst. Die dünn besetzte Synthese nimmt das Wörterbuch auf, so dass es nur einmal gelernt wird.</translation>
    </message>
    <message>
        <source>Least determinant of the Jacobian</source>
        <translation>Kleinste Determinante der Jacobi-Matrix</translation>
    </message>
    <message>
        <source>Levelling joints</source>
        <translation>Fugen ausgleichen</translation>
    </message>
    <message>
        <source>Levelling reach</source>
        <translation>Reichweite des Ausgleichs</translation>
    </message>
    <message>
        <source>Low frequencies</source>
        <translation>Tiefe Frequenzen</translation>
    </message>
    <message>
        <source>Low frequencies of</source>
        <translation>Tiefe Frequenzen von</translation>
    </message>
    <message>
        <source>Makes an image whose patches are each a sum of few learnt atoms, used as often as in the exemplar. New pixels rather than copies; sharp on small structures such as scales, weaves and cracks, and lost on large objects and on grain.</source>
        <translation>Erzeugt ein Bild, dessen Patches je eine Summe weniger gelernter Atome sind, die so oft benutzt werden wie in der Vorlage. Neue Pixel statt Kopien; scharf bei kleinen Strukturen wie Schuppen, Geflechten und Rissen, verloren bei großen Gegenständen und Körnung.</translation>
    </message>
    <message>
        <source>Map of the sheet</source>
        <translation>Karte des Bogens</translation>
    </message>
    <message>
        <source>Mean tile and components</source>
        <translation>Mittlere Kachel und Komponenten</translation>
    </message>
    <message>
        <source>Most rounds at each scale: more bring patches and image closer together.</source>
        <translation>Höchstzahl der Runden auf jeder Skala: mehr bringen Patches und Bild näher zusammen.</translation>
    </message>
    <message>
        <source>Moving blocks</source>
        <translation>Blöcke versetzen</translation>
    </message>
    <message>
        <source>Nearest pixel</source>
        <translation>Nächstes Pixel</translation>
    </message>
    <message>
        <source>No atom is used more often than in the exemplar: brings all features back, and keeps smooth patches from spreading.</source>
        <translation>Kein Atom wird öfter benutzt als in der Vorlage: bringt alle Merkmale wieder und verhindert, dass sich glatte Patches ausbreiten.</translation>
    </message>
    <message>
        <source>Normally</source>
        <translation>Normalverteilt</translation>
    </message>
    <message>
        <source>Online</source>
        <translation>Fortlaufend</translation>
    </message>
    <message>
        <source>Parabola</source>
        <translation>Parabel</translation>
    </message>
    <message>
        <source>Patches learnt from</source>
        <translation>Patches, aus denen gelernt wurde</translation>
    </message>
    <message>
        <source>Peyré 2009</source>
        <translation>Peyré 2009</translation>
    </message>
    <message>
        <source>Piece size</source>
        <translation>Stückgröße</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>Stücke</translation>
    </message>
    <message>
        <source>Pieces of the exemplar grow until nothing fits; jumps from 0 to 0.2 make them smaller. See the tab Copied pieces.</source>
        <translation>Stücke der Vorlage wachsen, bis nichts mehr passt; Sprünge von 0 bis 0,2 machen sie kleiner. Siehe die Karte „Kopierte Stücke“.</translation>
    </message>
    <message>
        <source>Poisson levels the joints and keeps the detail; a cut copies every pixel as it is; feathering blurs where pieces overlap; none shows the pieces.</source>
        <translation>Poisson gleicht die Fugen aus und behält die Details; ein Schnitt kopiert jedes Pixel, wie es ist; Überblenden verwischt, wo sich Stücke überlappen; ohne zeigt die Stücke.</translation>
    </message>
    <message>
        <source>Random mosaic</source>
        <translation>Zufallsmosaik</translation>
    </message>
    <message>
        <source>Reconstruction</source>
        <translation>Zusammensetzen</translation>
    </message>
    <message>
        <source>Repeat</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Root mean square error</source>
        <translation>Wurzel des mittleren quadratischen Fehlers</translation>
    </message>
    <message>
        <source>Rounds over all patches that are learnt from: more learn better, and take longer.</source>
        <translation>Runden über alle Patches, aus denen gelernt wird: mehr lernen besser und dauern länger.</translation>
    </message>
    <message>
        <source>Row by row on a single scale, with neighbourhoods of 5, 9, 15 and 21 px: the known half above and to the left decides.</source>
        <translation>Zeile für Zeile auf einer einzigen Skala, mit Nachbarschaften von 5, 9, 15 und 21 px: Die bekannte Hälfte darüber und links entscheidet.</translation>
    </message>
    <message>
        <source>STMap</source>
        <translation>STMap</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Maßstab</translation>
    </message>
    <message>
        <source>Share of a piece over which neighbours overlap, for cuts and feathering: larger joins better.</source>
        <translation>Anteil eines Stücks, über den sich Nachbarn überlappen, für Schnitte und Überblenden: Größer fügt besser.</translation>
    </message>
    <message>
        <source>Share of the variance in them</source>
        <translation>Ihr Anteil an der Varianz</translation>
    </message>
    <message>
        <source>Shuffling pieces</source>
        <translation>Stücke mischen</translation>
    </message>
    <message>
        <source>Side of a piece, or width of a slice: larger keeps larger structures whole, smaller makes outputs differ more.</source>
        <translation>Seite eines Stücks oder Breite eines Streifens: Größer lässt größere Strukturen ganz, kleiner macht Ausgaben verschiedener.</translation>
    </message>
    <message>
        <source>Side of the patches at each scale: larger keeps larger features whole and takes longer.</source>
        <translation>Seite der Patches auf jeder Skala: größer hält größere Merkmale ganz und dauert länger.</translation>
    </message>
    <message>
        <source>Side of the squares that are copied; 0 chooses by the exemplar and its lattice. Larger keeps larger stretches, smaller varies more. Whole tiles take it where rows do not repeat.</source>
        <translation>Seite der Quadrate, die kopiert werden; 0 wählt nach Vorlage und Gitter. Größer erhält größere Stücke, kleiner variiert mehr. Ganze Kacheln nehmen sie, wo Reihen sich nicht wiederholen.</translation>
    </message>
    <message>
        <source>Single tiles</source>
        <translation>Einzelne Kacheln</translation>
    </message>
    <message>
        <source>Sinusoid</source>
        <translation>Sinus</translation>
    </message>
    <message>
        <source>Size of the swirls: larger bends slower and moves farther.</source>
        <translation>Größe der Wirbel: Größer biegt langsamer und verschiebt weiter.</translation>
    </message>
    <message>
        <source>Slices keep what runs along them, as the grain of wood; pieces cut both ways suit what looks alike in all directions; chaos throws blocks over copies of the exemplar.</source>
        <translation>Streifen behalten, was an ihnen entlangläuft, wie die Maserung von Holz; in beide Richtungen geschnittene Stücke passen zu dem, was in alle Richtungen gleich aussieht; Chaos wirft Blöcke über Kopien der Vorlage.</translation>
    </message>
    <message>
        <source>Soft edge</source>
        <translation>Weicher Rand</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Sparse coding</source>
        <translation>Dünn besetzte Kodierung</translation>
    </message>
    <message>
        <source>Sparse synthesis</source>
        <translation>Dünn besetzte Synthese</translation>
    </message>
    <message>
        <source>Sparse synthesis beside statistics</source>
        <translation>Dünn besetzte Synthese neben Statistik</translation>
    </message>
    <message>
        <source>Sparse synthesis, as published</source>
        <translation>Dünn besetzte Synthese, wie veröffentlicht</translation>
    </message>
    <message>
        <source>Sparse synthesis, larger output</source>
        <translation>Dünn besetzte Synthese, größere Ausgabe</translation>
    </message>
    <message>
        <source>Sparse synthesis, micro-texture</source>
        <translation>Dünn besetzte Synthese, Mikrotextur</translation>
    </message>
    <message>
        <source>Sparse synthesis, step by step</source>
        <translation>Dünn besetzte Synthese, Schritt für Schritt</translation>
    </message>
    <message>
        <source>Spectrum</source>
        <translation>Spektrum</translation>
    </message>
    <message>
        <source>Steps of the image in each round, between two codings of its patches.</source>
        <translation>Schritte des Bildes in jeder Runde, zwischen zwei Kodierungen seiner Patches.</translation>
    </message>
    <message>
        <source>Stitching tiles</source>
        <translation>Kacheln anfügen</translation>
    </message>
    <message>
        <source>Table of tiles</source>
        <translation>Kacheltabelle</translation>
    </message>
    <message>
        <source>Texture by numbers</source>
        <translation>Textur nach Zahlen</translation>
    </message>
    <message>
        <source>The axis that the first three kinds deform; turbulence deforms both.</source>
        <translation>Die Achse, die die ersten drei Arten verformen; Turbulenz verformt beide.</translation>
    </message>
    <message>
        <source>The dictionary has patches of {} px, and the patch size is {} px; they need the same.</source>
        <translation>Das Wörterbuch hat Patches von {} px, und die Patchgröße ist {} px; beide müssen gleich sein.</translation>
    </message>
    <message>
        <source>The dictionary says that it has {} scales of {} channels in patches of {} px.</source>
        <translation>Das Wörterbuch gibt {} Skalen mit {} Kanälen in Patches von {} px an.</translation>
    </message>
    <message>
        <source>The dictionary&apos;s counts of uses at scale {} make no sense.</source>
        <translation>Die Nutzungszahlen des Wörterbuchs auf der Skala {} ergeben keinen Sinn.</translation>
    </message>
    <message>
        <source>The exemplar itself, as published, gives its own layout of light and dark, and is only possible at its size; random phases give a new one at any size. Whatever fits takes the exemplar where sizes are the same and nothing wraps.</source>
        <translation>Die Vorlage selbst, wie veröffentlicht, ergibt ihre eigene Anordnung von Hell und Dunkel und geht nur in ihrer Größe; Zufallsphasen ergeben eine neue in jeder Größe. Was passt nimmt die Vorlage, wo die Größen gleich sind und nichts kachelt.</translation>
    </message>
    <message>
        <source>The exemplar&apos;s own low frequencies fit an output of its size, {} × {} px, and this one is {} × {} px; choose random phases.</source>
        <translation>Die eigenen tiefen Frequenzen der Vorlage passen zu einer Ausgabe ihrer Größe, {} × {} px, und diese ist {} × {} px groß; wählen Sie Zufallsphasen.</translation>
    </message>
    <message>
        <source>The first three stretch and squeeze along one axis; turbulence swirls along both.</source>
        <translation>Die ersten drei strecken und stauchen entlang einer Achse; Turbulenz wirbelt entlang beider.</translation>
    </message>
    <message>
        <source>The hole is filled with patches of {} px: larger ones would cover most of it.</source>
        <translation>Das Loch wird mit Flicken von {} px gefüllt: Größere würden das meiste davon bedecken.</translation>
    </message>
    <message>
        <source>The image to start from is {} × {} px, smaller than the patch of {} px; choose a patch of at most {} px.</source>
        <translation>Das Ausgangsbild hat {} × {} px, weniger als der Flicken von {} px; wählen Sie einen Flicken von höchstens {} px.</translation>
    </message>
    <message>
        <source>The lattice&apos;s tile of {} × {} px does not fit into {} of {} × {} px; choose unit=blocks.</source>
        <translation>Die Kachel des Gitters mit {} × {} px passt nicht in {} mit {} × {} px; wählen Sie unit=blocks.</translation>
    </message>
    <message>
        <source>The learnt atoms of each scale, and how often each is used.</source>
        <translation>Die gelernten Atome jeder Skala, und wie oft jedes benutzt wird.</translation>
    </message>
    <message>
        <source>The map&apos;s pixel ({}, {}) comes from exemplar {}, but there are {}.</source>
        <translation>Das Pixel ({}, {}) der Karte kommt aus Vorlage {}, aber es gibt {}.</translation>
    </message>
    <message>
        <source>The mask hides all of the exemplar; leave some of it to lay, at least {} px.</source>
        <translation>Die Maske verdeckt die ganze Vorlage; lassen Sie etwas davon frei, mindestens {} px.</translation>
    </message>
    <message>
        <source>The mask leaves no whole block of {} px to lay; choose smaller blocks or mask less.</source>
        <translation>Die Maske lässt keinen ganzen Block von {} px zum Legen frei; wählen Sie kleinere Blöcke oder maskieren Sie weniger.</translation>
    </message>
    <message>
        <source>The mask leaves no whole piece of {} px to lay; choose smaller pieces or mask less.</source>
        <translation>Die Maske lässt kein ganzes Stück von {} px zum Legen frei; wählen Sie kleinere Stücke oder maskieren Sie weniger.</translation>
    </message>
    <message>
        <source>The mask leaves no whole tile of {} × {} px to copy; mask less, or choose unit=blocks.</source>
        <translation>Die Maske lässt keine ganze Kachel von {} × {} px zum Kopieren übrig; maskieren Sie weniger, oder wählen Sie unit=blocks.</translation>
    </message>
    <message>
        <source>The model has no array {} with atoms in it.</source>
        <translation>Das Modell hat kein Feld {} mit Atomen darin.</translation>
    </message>
    <message>
        <source>The same exemplar with windows of 5, 9, 15 and 25 px: too small a window grows garbage, too large a one copies verbatim.</source>
        <translation>Dieselbe Vorlage mit Fenstern von 5, 9, 15 und 25 px: Ein zu kleines lässt Unsinn wachsen, ein zu großes kopiert wörtlich.</translation>
    </message>
    <message>
        <source>The spacing of {} px leaves gaps between patches of {} px; choose at most {} px.</source>
        <translation>Der Abstand von {} px lässt Lücken zwischen Patches von {} px; wählen Sie höchstens {} px.</translation>
    </message>
    <message>
        <source>The waves alone, of the output&apos;s size: the texture without its irregularities.</source>
        <translation>Die Wellen allein, in der Größe der Ausgabe: die Textur ohne ihre Unregelmäßigkeiten.</translation>
    </message>
    <message>
        <source>Three methods, pixel by pixel</source>
        <translation>Drei Verfahren, Pixel für Pixel</translation>
    </message>
    <message>
        <source>Tile sheet</source>
        <translation>Kachelbogen</translation>
    </message>
    <message>
        <source>Tile with overlap, height</source>
        <translation>Kachel mit Überlappung, Höhe</translation>
    </message>
    <message>
        <source>Tile with overlap, width</source>
        <translation>Kachel mit Überlappung, Breite</translation>
    </message>
    <message>
        <source>Tiles stitched</source>
        <translation>Angefügte Kacheln</translation>
    </message>
    <message>
        <source>Turbulence</source>
        <translation>Turbulenz</translation>
    </message>
    <message>
        <source>Turn pieces</source>
        <translation>Stücke drehen</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Varied</source>
        <translation>Verschieden</translation>
    </message>
    <message>
        <source>Waves of the sinusoid over the whole: more of them move less far.</source>
        <translation>Wellen des Sinus über das Ganze: Mehr davon verschieben weniger weit.</translation>
    </message>
    <message>
        <source>Weight of low frequencies</source>
        <translation>Gewicht der tiefen Frequenzen</translation>
    </message>
    <message>
        <source>Weight of the histogram</source>
        <translation>Gewicht des Histogramms</translation>
    </message>
    <message>
        <source>Weight of the spectrum</source>
        <translation>Gewicht des Spektrums</translation>
    </message>
    <message>
        <source>Wei–Levoy on one scale</source>
        <translation>Wei–Levoy auf einer Skala</translation>
    </message>
    <message>
        <source>Wei–Levoy, Ashikhmin and image analogies on one exemplar: the first blurs small things, the second shows joins, the third weighs one against the other.</source>
        <translation>Wei–Levoy, Ashikhmin und Bildanalogien an einer Vorlage: Das erste verwischt Kleines, das zweite zeigt Nähte, das dritte wägt beides ab.</translation>
    </message>
    <message>
        <source>Whatever fits</source>
        <translation>Was passt</translation>
    </message>
    <message>
        <source>Where a hole is filled, how far around it the same picture is copied from: smaller takes what is near, and is faster; 0 takes all of the picture.</source>
        <translation>Wo ein Loch gefüllt wird, aus welchem Umkreis desselben Bildes kopiert wird: Kleiner nimmt, was nah ist, und ist schneller; 0 nimmt das ganze Bild.</translation>
    </message>
    <message>
        <source>Where a hole is filled, how far from its own place in an exemplar of the output&apos;s size a pixel&apos;s source may lie: smaller takes what is near; 0 looks everywhere.</source>
        <translation>Wo ein Loch gefüllt wird, wie weit die Quelle eines Pixels in einer Vorlage von der Größe des Ergebnisses von dessen eigener Stelle liegen darf: Kleiner nimmt, was nah ist; 0 sucht überall.</translation>
    </message>
    <message>
        <source>Where each pixel comes from, between pixels too, as compositors read it: .exr, of 32-bit floats. `apply` lays out another map by it.</source>
        <translation>Woher jedes Pixel kommt, auch zwischen Pixeln, wie Compositing-Programme es lesen: .exr mit 32-Bit-Gleitkommazahlen. `apply` legt damit eine andere Karte aus.</translation>
    </message>
    <message>
        <source>Where each pixel of the sheet comes from: `apply` makes the same sheet of companion maps with it.</source>
        <translation>Woher jedes Pixel des Bogens stammt: `apply` macht damit denselben Bogen aus Begleitkarten.</translation>
    </message>
    <message>
        <source>Whole tiles</source>
        <translation>Ganze Kacheln</translation>
    </message>
    <message>
        <source>With the exemplar&apos;s spectrum, which brings back the fine grain of grass, sand or cloth that few atoms cannot code.</source>
        <translation>Mit dem Spektrum der Vorlage, das die feine Körnung von Gras, Sand oder Stoff zurückbringt, die wenige Atome nicht darstellen können.</translation>
    </message>
    <message>
        <source>picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>{} cannot hold an STMap, which needs 32-bit floats; its name ends in .exr.</source>
        <translation>{} kann keine STMap aufnehmen, die 32-Bit-Gleitkommazahlen braucht; der Name endet auf .exr.</translation>
    </message>
    <message>
        <source>{} declares {} for its output {}, but made something else; this is a mistake in the method.</source>
        <translation>{} gibt {} als Ausgabe {} an, hat aber etwas anderes erzeugt; das ist ein Fehler im Verfahren.</translation>
    </message>
    <message>
        <source>{} gives {} to {} for its output {}, but made {}; this is a mistake in the method.</source>
        <translation>{} liefert {} bis {} für die Ausgabe {}, hat aber {} erzeugt; das ist ein Fehler im Verfahren.</translation>
    </message>
    <message>
        <source>{} holds only one whole tile, so that nothing varies; a larger exemplar or a smaller tile shows how tiles differ.</source>
        <translation>{} enthält nur eine ganze Kachel, sodass nichts variiert; eine größere Vorlage oder eine kleinere Kachel zeigt, wie Kacheln sich unterscheiden.</translation>
    </message>
    <message>
        <source>{} is one piece of this size, so that the output only repeats it; choose pieces of at most {} px.</source>
        <translation>{} ist bei dieser Größe ein einziges Stück, sodass die Ausgabe es nur wiederholt; wählen Sie Stücke von höchstens {} px.</translation>
    </message>
    <message>
        <source>{} is {} × {} px, smaller than a piece of {} px; choose pieces of at most {} px.</source>
        <translation>{} hat {} × {} px, weniger als ein Stück von {} px; wählen Sie Stücke von höchstens {} px.</translation>
    </message>
    <message>
        <source>{} learns from no exemplar, so that it makes no companion maps; leave them out.</source>
        <translation>{} lernt von keiner Vorlage und erzeugt deshalb keine Begleitkarten; lassen Sie sie weg.</translation>
    </message>
    <message>
        <source>{} made a model of the kind {} for its output {}, which takes one of its own kind; this is a mistake in the method.</source>
        <translation>{} hat ein Modell der Art {} für die Ausgabe {} erzeugt, die eines ihrer eigenen Art verlangt; das ist ein Fehler im Verfahren.</translation>
    </message>
    <message>
        <source>{} made an output {} that it does not declare; this is a mistake in the method.</source>
        <translation>{} hat eine Ausgabe {} erzeugt, die es nicht angibt; das ist ein Fehler im Verfahren.</translation>
    </message>
    <message>
        <source>Algorithm 1 of Gutierrez&apos; thesis: the whole assignment at 3 scales with 50, 50 and 10 rounds, medians by Douglas–Rachford splitting. Hours and gigabytes for large outputs.</source>
        <translation>Algorithmus 1 aus Gutierrez’ Dissertation: die ganze Zuordnung auf 3 Stufen mit 50, 50 und 10 Runden, Mediane durch Douglas-Rachford-Aufspaltung. Stunden und Gigabytes bei großen Ausgaben.</translation>
    </message>
    <message>
        <source>All channels together</source>
        <translation>Alle Kanäle zusammen</translation>
    </message>
    <message>
        <source>As the source prints it: channels may choose differently.</source>
        <translation>Wie es die Quelle druckt: Kanäle können verschieden wählen.</translation>
    </message>
    <message>
        <source>At this size every patch chose among a few that suit it, so some are used a little more often than others; the setting “Solved” = Whole takes much longer and uses all as they should be.</source>
        <translation>Bei dieser Größe wählte jedes Stück unter wenigen passenden; daher werden einige etwas öfter verwendet als andere. Die Einstellung „Gelöst“ = Ganz dauert viel länger und verwendet alle, wie sie sollen.</translation>
    </message>
    <message>
        <source>Black where the second image is cloned. Without it, that is the middle half of its width and height.</source>
        <translation>Schwarz, wo das zweite Bild geklont wird. Ohne sie ist das die mittlere Hälfte seiner Breite und Höhe.</translation>
    </message>
    <message>
        <source>Border of the first</source>
        <translation>Rand des ersten</translation>
    </message>
    <message>
        <source>Choosing gradients</source>
        <translation>Gradienten wählen</translation>
    </message>
    <message>
        <source>Clone seamlessly</source>
        <translation>Nahtlos klonen</translation>
    </message>
    <message>
        <source>Closed</source>
        <translation>Geschlossen</translation>
    </message>
    <message>
        <source>Conditional Gaussian, as published</source>
        <translation>Bedingt gaußsch, wie veröffentlicht</translation>
    </message>
    <message>
        <source>Constant tolerance</source>
        <translation>Gleichbleibende Toleranz</translation>
    </message>
    <message>
        <source>Each channel for itself</source>
        <translation>Jeder Kanal für sich</translation>
    </message>
    <message>
        <source>Each channel takes its own stronger gradient, as printed; otherwise the length over all channels decides for the pixel, so that no false colours appear.</source>
        <translation>Jeder Kanal nimmt seinen eigenen stärkeren Gradienten, wie gedruckt; sonst entscheidet die Länge über alle Kanäle für das Pixel, sodass keine falschen Farben auftreten.</translation>
    </message>
    <message>
        <source>Every patch chose among a few that suit it, as asked, so some are used a little more often than others.</source>
        <translation>Jedes Stück wählte, wie verlangt, unter wenigen passenden; daher werden einige etwas öfter verwendet als andere.</translation>
    </message>
    <message>
        <source>Factor on the first image&apos;s gradients before they are compared: larger keeps more of the first image.</source>
        <translation>Faktor auf die Gradienten des ersten Bildes vor dem Vergleich: größer behält mehr vom ersten Bild.</translation>
    </message>
    <message>
        <source>Free, mean of the first</source>
        <translation>Frei, Mittel des ersten</translation>
    </message>
    <message>
        <source>Gaussian patches, as published</source>
        <translation>Gauß-Stücke, wie veröffentlicht</translation>
    </message>
    <message>
        <source>Goes on over the border, for images that wrap.</source>
        <translation>Geht über den Rand weiter, für Bilder, die sich schließen.</translation>
    </message>
    <message>
        <source>How far below its place in the second image the region comes to lie in the first.</source>
        <translation>Wie weit unter seinem Platz im zweiten Bild der Bereich im ersten zu liegen kommt.</translation>
    </message>
    <message>
        <source>How far right of its place in the second image the region comes to lie in the first.</source>
        <translation>Wie weit rechts von seinem Platz im zweiten Bild der Bereich im ersten zu liegen kommt.</translation>
    </message>
    <message>
        <source>How overlapping patches are joined: the geometric median (r = 1) as published, the mean (r = 2), which blurs, or robust weights (r = 0.8).</source>
        <translation>Wie überlappende Stücke verbunden werden: der geometrische Median (r = 1), wie veröffentlicht, der Mittelwert (r = 2), der weichzeichnet, oder robuste Gewichte (r = 0,8).</translation>
    </message>
    <message>
        <source>How patches are assigned: whole, as published, uses every patch as often as it should be and may take hours and gigabytes for large outputs; narrowed lets each patch choose among a few; automatic is whole up to some minutes.</source>
        <translation>Wie Stücke zugeordnet werden: ganz, wie veröffentlicht, verwendet jedes Stück so oft, wie es soll, und kann bei großen Ausgaben Stunden und Gigabytes brauchen; eingeschränkt lässt jedes Stück unter wenigen wählen; automatisch ist ganz bis zu einigen Minuten.</translation>
    </message>
    <message>
        <source>How the most similar patch is found: exactly, or nearly and faster with large exemplars. With uniformity, always exactly.</source>
        <translation>Wie das ähnlichste Stück gefunden wird: genau, oder annähernd und bei großen Vorlagen schneller. Mit Gleichmäßigkeit immer genau.</translation>
    </message>
    <message>
        <source>Joining gradients</source>
        <translation>Gradienten zusammenfügen</translation>
    </message>
    <message>
        <source>Keeps the tolerance as it is on the finest scale, as published, where it otherwise falls from round to round.</source>
        <translation>Lässt die Toleranz auf der feinsten Stufe, wie sie ist, wie veröffentlicht; sonst fällt sie dort von Runde zu Runde.</translation>
    </message>
    <message>
        <source>Kwatra et al. as Gutierrez&apos; thesis, section 3.1, gives it: patches of 32, 16 and 8 px at 3 scales, robust weights with a Gaussian falloff, no uniformity.</source>
        <translation>Kwatra et al., wie Gutierrez’ Dissertation, Abschnitt 3.1, es wiedergibt: Stücke von 32, 16 und 8 px auf 3 Stufen, robuste Gewichte mit gaußschem Abfall, keine Gleichmäßigkeit.</translation>
    </message>
    <message>
        <source>Lays the structure of one image over another: each pixel gets the stronger of the two gradients. Suits a plain material and one with marks of the same kind.</source>
        <translation>Legt die Struktur eines Bildes über ein anderes: Jedes Pixel erhält den stärkeren der beiden Gradienten. Passt zu einem schlichten Material und einem gleicher Art mit Zeichnung.</translation>
    </message>
    <message>
        <source>Locally Gaussian, as published</source>
        <translation>Lokal gaußsch, wie veröffentlicht</translation>
    </message>
    <message>
        <source>Midway quilting, as published</source>
        <translation>Midway-Quilting, wie veröffentlicht</translation>
    </message>
    <message>
        <source>Mix by gradients</source>
        <translation>Nach Gradienten mischen</translation>
    </message>
    <message>
        <source>Mixed</source>
        <translation>Gemischt</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Modus</translation>
    </message>
    <message>
        <source>Moved by {}, {} px, the region of the second image does not lie over the first of {} × {} px; move it less, or paint it elsewhere.</source>
        <translation>Um {}, {} px verschoben liegt der Bereich des zweiten Bildes nicht über dem ersten von {} × {} px; verschieben Sie ihn weniger, oder malen Sie ihn anderswo.</translation>
    </message>
    <message>
        <source>Moved down</source>
        <translation>Nach unten verschoben</translation>
    </message>
    <message>
        <source>Moved right</source>
        <translation>Nach rechts verschoben</translation>
    </message>
    <message>
        <source>Multiscale Gaussian, as published</source>
        <translation>Mehrskalig gaußsch, wie veröffentlicht</translation>
    </message>
    <message>
        <source>Narrowed</source>
        <translation>Eingeschränkt</translation>
    </message>
    <message>
        <source>Near-regular, as published</source>
        <translation>Fast regelmäßig, wie veröffentlicht</translation>
    </message>
    <message>
        <source>Pasted</source>
        <translation>Eingefügt</translation>
    </message>
    <message>
        <source>Patch assignment, as published</source>
        <translation>Stückzuordnung, wie veröffentlicht</translation>
    </message>
    <message>
        <source>Patches used beyond their share</source>
        <translation>Über ihren Anteil hinaus verwendete Stücke</translation>
    </message>
    <message>
        <source>Preference</source>
        <translation>Vorzug</translation>
    </message>
    <message>
        <source>Puts a region of the second image into the first one, so that no seam shows: its structure comes along, its light and colour are those around it.</source>
        <translation>Setzt einen Bereich des zweiten Bildes in das erste, ohne dass eine Naht zu sehen ist: Seine Struktur kommt mit, Licht und Farbe sind die der Umgebung.</translation>
    </message>
    <message>
        <source>Quilting, as published</source>
        <translation>Quilting, wie veröffentlicht</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>Bereich</translation>
    </message>
    <message>
        <source>Regular tile, as published</source>
        <translation>Regelmäßige Kachel, wie veröffentlicht</translation>
    </message>
    <message>
        <source>Replaced</source>
        <translation>Ersetzt</translation>
    </message>
    <message>
        <source>Settled at</source>
        <translation>Beendet bei</translation>
    </message>
    <message>
        <source>Solved</source>
        <translation>Gelöst</translation>
    </message>
    <message>
        <source>Texture optimisation, as published</source>
        <translation>Texturoptimierung, wie veröffentlicht</translation>
    </message>
    <message>
        <source>That of the first</source>
        <translation>Der des ersten</translation>
    </message>
    <message>
        <source>The experiment of Raad&apos;s thesis, figure 2.1: patches of 30 px from 10 neighbours, contrast not balanced.</source>
        <translation>Der Versuch aus Raads Dissertation, Abbildung 2.1: Stücke von 30 px aus 10 Nachbarn, Kontrast nicht ausgeglichen.</translation>
    </message>
    <message>
        <source>The longer gradient over all channels: no colour that neither image has.</source>
        <translation>Der längere Gradient über alle Kanäle: keine Farbe, die keines der Bilder hat.</translation>
    </message>
    <message>
        <source>The mask is {} × {} px, the second image {} × {} px; paint it on that image.</source>
        <translation>Die Maske hat {} × {} px, das zweite Bild {} × {} px; malen Sie sie auf dieses Bild.</translation>
    </message>
    <message>
        <source>The pixels as they are, to compare with.</source>
        <translation>Die Pixel, wie sie sind, zum Vergleich.</translation>
    </message>
    <message>
        <source>The pixels at the border stay as they are in the first image.</source>
        <translation>Die Pixel am Rand bleiben, wie sie im ersten Bild sind.</translation>
    </message>
    <message>
        <source>The region covers all of the first image of {} × {} px, so that there is nothing to join it with; paint a smaller one.</source>
        <translation>Der Bereich bedeckt das ganze erste Bild von {} × {} px, sodass nichts da ist, woran er anschließt; malen Sie einen kleineren.</translation>
    </message>
    <message>
        <source>The rule of López Recas 2011, section 4.1: the tile that joins itself best, compared over borders of 2 × 8 px.</source>
        <translation>Die Regel von López Recas 2011, Abschnitt 4.1: die Kachel, die am besten an sich selbst anschließt, verglichen über Ränder von 2 × 8 px.</translation>
    </message>
    <message>
        <source>The settings of López Recas 2011, section 4.2: blocks of 40 px with borders of 10 px, blended over 4 px, light left as it is.</source>
        <translation>Die Einstellungen von López Recas 2011, Abschnitt 4.2: Blöcke von 40 px mit Rändern von 10 px, über 4 px überblendet, Licht wie es ist.</translation>
    </message>
    <message>
        <source>The settings of Raad&apos;s thesis, figure 2.6: patches of 30 px from 10 neighbours joined along cuts, contrast not balanced.</source>
        <translation>Die Einstellungen aus Raads Dissertation, Abbildung 2.6: Stücke von 30 px aus 10 Nachbarn, entlang von Schnitten verbunden, Kontrast nicht ausgeglichen.</translation>
    </message>
    <message>
        <source>The settings of Raad&apos;s thesis, figure 3.4: patches of 40 px from 30 neighbours that overlap by half, contrast not balanced. Fades on most photographs, as the source says.</source>
        <translation>Die Einstellungen aus Raads Dissertation, Abbildung 3.4: Stücke von 40 px aus 30 Nachbarn, die sich zur Hälfte überlappen, Kontrast nicht ausgeglichen. Verblasst bei den meisten Fotos, wie die Quelle sagt.</translation>
    </message>
    <message>
        <source>The settings of Raad&apos;s thesis, figure 3.5: patches of 20 px from 50 neighbours at 3 scales, averaged at the coarsest and pasted at the others, contrast not balanced.</source>
        <translation>Die Einstellungen aus Raads Dissertation, Abbildung 3.5: Stücke von 20 px aus 50 Nachbarn auf 3 Stufen, auf der gröbsten gemittelt und auf den anderen eingesetzt, Kontrast nicht ausgeglichen.</translation>
    </message>
    <message>
        <source>The settings of Raad&apos;s thesis, figure 4.21: patches of 40 px that overlap by 0.45, contrast not balanced.</source>
        <translation>Die Einstellungen aus Raads Dissertation, Abbildung 4.21: Stücke von 40 px, die sich zu 0,45 überlappen, Kontrast nicht ausgeglichen.</translation>
    </message>
    <message>
        <source>The stronger structure of both, so that the first shows through.</source>
        <translation>Die stärkere Struktur von beiden, sodass das erste durchscheint.</translation>
    </message>
    <message>
        <source>The structure of the second image alone.</source>
        <translation>Allein die Struktur des zweiten Bildes.</translation>
    </message>
    <message>
        <source>What holds at the border: nothing, and the mean is that of the first image; the pixels of the first image; or that the image closes on itself.</source>
        <translation>Was am Rand gilt: nichts, und das Mittel ist das des ersten Bildes; die Pixel des ersten Bildes; oder dass das Bild sich schließt.</translation>
    </message>
    <message>
        <source>Whole</source>
        <translation>Ganz</translation>
    </message>
    <message>
        <source>Whose gradients fill the region: those of the second image, the stronger ones of both, or none: pixels are pasted.</source>
        <translation>Wessen Gradienten den Bereich füllen: die des zweiten Bildes, die stärkeren von beiden oder keine: Pixel werden eingefügt.</translation>
    </message>
    <message>
        <source>With a tolerance or relaxed: rounds end when the cost falls by less than this share; 0 goes on to the last round, as published.</source>
        <translation>Mit Toleranz oder gelockert: Die Runden enden, wenn die Kosten um weniger als diesen Anteil fallen; 0 geht bis zur letzten Runde, wie veröffentlicht.</translation>
    </message>
    <message>
        <source>The system gives the program no further thread; raise its limits (ulimit -v and -u), or use fewer threads.</source>
        <translation>Das System gibt dem Programm keinen weiteren Thread; heben Sie seine Grenzen an (ulimit -v und -u) oder nehmen Sie weniger Threads.</translation>
    </message>
    <message>
        <source>A descriptor&apos;s file is given and another descriptor chosen: choose automatic, or leave the file out.</source>
        <translation>Eine Deskriptordatei ist angegeben und ein anderer Deskriptor gewählt: wählen Sie „Automatisch“ oder lassen Sie die Datei weg.</translation>
    </message>
    <message>
        <source>A layer of the network takes {} channels of at least {}×{} px, and has {} of {}×{} px.</source>
        <translation>Eine Schicht des Netzes nimmt {} Kanäle von mindestens {}×{} px und hat {} von {}×{} px.</translation>
    </message>
    <message>
        <source>A network of your own, such as one that import-descriptor or learn-descriptor made.</source>
        <translation>Ein eigenes Netz, etwa eines von import-descriptor oder learn-descriptor.</translation>
    </message>
    <message>
        <source>A normal map needs 3 channels, and this one has {}; choose another map, or say what it holds.</source>
        <translation>Eine Normalenkarte braucht 3 Kanäle, und diese hat {}; wählen Sie eine andere oder sagen Sie, was sie enthält.</translation>
    </message>
    <message>
        <source>A panorama needs 3 channels of light, and this one has {}; choose another picture.</source>
        <translation>Ein Panorama braucht 3 Kanäle Licht, und dieses hat {}; wählen Sie ein anderes Bild.</translation>
    </message>
    <message>
        <source>A point at {} lies too far out; coordinates go from −{} to {}.</source>
        <translation>Ein Punkt bei {} liegt zu weit draußen; Koordinaten gehen von −{} bis {}.</translation>
    </message>
    <message>
        <source>A solid of {} voxels a side holds no neighbourhood of {}.</source>
        <translation>Ein Körper mit {} Voxeln je Seite enthält keine Nachbarschaft von {}.</translation>
    </message>
    <message>
        <source>A step gave values that are not numbers: the optimisation ended with the last that are.</source>
        <translation>Ein Schritt ergab Werte, die keine Zahlen sind: die Optimierung endete mit den letzten, die welche sind.</translation>
    </message>
    <message>
        <source>A trained generator to go on from.</source>
        <translation>Ein trainierter Generator, von dem aus es weitergeht.</translation>
    </message>
    <message>
        <source>Adam</source>
        <translation>Adam</translation>
    </message>
    <message>
        <source>All three axes are free, so that nothing is wanted of the solid; give one of them an exemplar and a weight.</source>
        <translation>Alle drei Achsen sind frei, sodass vom Körper nichts verlangt wird; geben Sie einer von ihnen eine Vorlage und ein Gewicht.</translation>
    </message>
    <message>
        <source>All {} × {} px of the image to start from are known, so that there is nothing to make; mask less.</source>
        <translation>Alle {} × {} px des Ausgangsbilds sind bekannt, sodass nichts zu machen ist; maskieren Sie weniger.</translation>
    </message>
    <message>
        <source>Also compares the distribution of colours, which networks alone let drift.</source>
        <translation>Vergleicht auch die Verteilung der Farben, die Netze allein abdriften lassen.</translation>
    </message>
    <message>
        <source>An exemplar of {}×{} px is too small for the network, which needs {} px a side.</source>
        <translation>Eine Vorlage von {}×{} px ist zu klein für das Netz, das je Seite {} px braucht.</translation>
    </message>
    <message>
        <source>Anamorphosis: bending what repeats</source>
        <translation>Anamorphose: biegen, was sich wiederholt</translation>
    </message>
    <message>
        <source>As it is</source>
        <translation>Wie sie ist</translation>
    </message>
    <message>
        <source>As the descriptor says</source>
        <translation>Wie der Deskriptor sagt</translation>
    </message>
    <message>
        <source>At each scale: more come closer to the exemplar and take longer.</source>
        <translation>Auf jeder Skala: mehr kommen der Vorlage näher und dauern länger.</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Änderung</translation>
    </message>
    <message>
        <source>Changes noise, or an initial image, until the feature maps of a network vary together as the exemplar&apos;s do. New pixels rather than copies; long straight structures may bend or break.</source>
        <translation>Ändert Rauschen oder ein Ausgangsbild, bis die Merkmalskarten eines Netzes so miteinander schwanken wie die der Vorlage. Neue Pixel statt Kopien; lange gerade Strukturen können sich biegen oder brechen.</translation>
    </message>
    <message>
        <source>Compare colours</source>
        <translation>Farben vergleichen</translation>
    </message>
    <message>
        <source>Cutting a slice</source>
        <translation>Ein Schnitt wird gelegt</translation>
    </message>
    <message>
        <source>Descriptor</source>
        <translation>Deskriptor</translation>
    </message>
    <message>
        <source>Descriptor: {} (licence {}; {}; SHA-1 {}).</source>
        <translation>Deskriptor: {} (Lizenz {}; {}; SHA-1 {}).</translation>
    </message>
    <message>
        <source>Distance of neighbourhoods</source>
        <translation>Abstand der Nachbarschaften</translation>
    </message>
    <message>
        <source>Even tone</source>
        <translation>Ton angleichen</translation>
    </message>
    <message>
        <source>Evening tone</source>
        <translation>Ton wird angeglichen</translation>
    </message>
    <message>
        <source>Exemplar&apos;s side</source>
        <translation>Seite der Vorlage</translation>
    </message>
    <message>
        <source>Exemplars with a longer side are scaled down to this: smaller makes features smaller, so that a solid holds more of them.</source>
        <translation>Vorlagen mit einer längeren Seite werden darauf verkleinert: Kleiner macht Merkmale kleiner, sodass ein Körper mehr von ihnen enthält.</translation>
    </message>
    <message>
        <source>Figure 5.42 of Raad&apos;s thesis on free exemplars: metal and rock with random low frequencies. Where high and low frequencies go together, as here, it shows.</source>
        <translation>Abbildung 5.42 aus Raads Dissertation an freien Vorlagen: Metall und Fels mit zufälligen tiefen Frequenzen. Wo hohe und tiefe Frequenzen zusammengehören, wie hier, sieht man es.</translation>
    </message>
    <message>
        <source>Figures 5.31 to 5.35 of Raad&apos;s thesis on free exemplars: wood and rock bent along one axis and along both. From farther away they remain much alike.</source>
        <translation>Die Abbildungen 5.31 bis 5.35 aus Raads Dissertation an freien Vorlagen: Holz und Fels, entlang einer und beider Achsen gebogen. Von Weitem bleiben sie einander sehr ähnlich.</translation>
    </message>
    <message>
        <source>First</source>
        <translation>Erste</translation>
    </message>
    <message>
        <source>First tap</source>
        <translation>Erster Abgriff</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>Frei</translation>
    </message>
    <message>
        <source>Generator</source>
        <translation>Generator</translation>
    </message>
    <message>
        <source>Gives all exemplars the colours of the first, without which slices of two kinds cannot agree where they cross.</source>
        <translation>Gibt allen Vorlagen die Farben der ersten, ohne die Schnitte zweier Arten dort nicht übereinstimmen können, wo sie sich kreuzen.</translation>
    </message>
    <message>
        <source>Gives the result the exemplar&apos;s distribution of colours at the end.</source>
        <translation>Gibt dem Ergebnis am Ende die Farbverteilung der Vorlage.</translation>
    </message>
    <message>
        <source>Gram</source>
        <translation>Gram</translation>
    </message>
    <message>
        <source>Gram matrices of a network</source>
        <translation>Gram-Matrizen eines Netzes</translation>
    </message>
    <message>
        <source>Half</source>
        <translation>Halb</translation>
    </message>
    <message>
        <source>How far Adam moves in one step, in deviations of the exemplar&apos;s colours: larger is faster and less exact.</source>
        <translation>Wie weit Adam in einem Schritt geht, in Abweichungen der Farben der Vorlage: größer ist schneller und ungenauer.</translation>
    </message>
    <message>
        <source>How far each step goes at the beginning; it falls to a twentieth. Too large, and the loss jumps; too small, and it falls slowly.</source>
        <translation>Wie weit jeder Schritt am Anfang geht; es fällt auf ein Zwanzigstel. Zu groß, und der Verlust springt; zu klein, und er fällt langsam.</translation>
    </message>
    <message>
        <source>How much rough pixels are avoided: more smooths noise and fine detail alike.</source>
        <translation>Wie sehr raue Pixel vermieden werden: mehr glättet Rauschen und feine Einzelheiten gleichermaßen.</translation>
    </message>
    <message>
        <source>How much the distribution of small patches counts, which makes edges sharper; 0 leaves it to the descriptor.</source>
        <translation>Wie viel die Verteilung kleiner Ausschnitte zählt, die Kanten schärfer macht; 0 überlässt es dem Deskriptor.</translation>
    </message>
    <message>
        <source>How much the features count that the descriptor sees in slices; 0 compares patches alone.</source>
        <translation>Wie viel die Merkmale zählen, die der Deskriptor in Schnitten sieht; 0 vergleicht nur Ausschnitte.</translation>
    </message>
    <message>
        <source>How much these slices count beside the others; 0 leaves the axis free.</source>
        <translation>Wie viel diese Schnitte neben den anderen zählen; 0 lässt die Achse frei.</translation>
    </message>
    <message>
        <source>How the exemplar is turned in these slices; where they meet, patterns must agree.</source>
        <translation>Wie die Vorlage in diesen Schnitten gedreht ist; wo sie sich treffen, müssen die Muster zusammenpassen.</translation>
    </message>
    <message>
        <source>How the network halves its feature maps: by their mean, or by the largest of four values.</source>
        <translation>Wie das Netz seine Merkmalskarten halbiert: durch ihr Mittel oder den größten von vier Werten.</translation>
    </message>
    <message>
        <source>How the weights of a patch&apos;s atoms are found: plain, as published, adds one atom after another; orthogonal finds all weights again with every atom, which follows the patch more closely and takes a little longer.</source>
        <translation>Wie die Gewichte der Atome eines Patches gefunden werden: einfach, wie veröffentlicht, fügt ein Atom nach dem anderen hinzu; orthogonal bestimmt mit jedem Atom alle Gewichte neu, folgt dem Patch enger und braucht etwas länger.</translation>
    </message>
    <message>
        <source>L-BFGS</source>
        <translation>L-BFGS</translation>
    </message>
    <message>
        <source>L-BFGS learns the curvature of the loss and comes further in as many iterations; Adam takes steps of one length.</source>
        <translation>L-BFGS lernt die Krümmung des Verlusts und kommt mit gleich vielen Iterationen weiter; Adam macht Schritte von einer Länge.</translation>
    </message>
    <message>
        <source>Last tap</source>
        <translation>Letzter Abgriff</translation>
    </message>
    <message>
        <source>Learned from the exemplar</source>
        <translation>Aus der Vorlage gelernt</translation>
    </message>
    <message>
        <source>Learning rate</source>
        <translation>Lernrate</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Levels</source>
        <translation>Stufen</translation>
    </message>
    <message>
        <source>Loss</source>
        <translation>Verlust</translation>
    </message>
    <message>
        <source>Low frequencies: three of each</source>
        <translation>Tiefe Frequenzen: je drei</translation>
    </message>
    <message>
        <source>Makes a solid block that repeats in all directions and whose slices look like the exemplar, or like one exemplar for each direction. The picture is its slice at z = 0.</source>
        <translation>Macht einen Block, der sich in alle Richtungen wiederholt und dessen Schnitte wie die Vorlage aussehen, oder wie eine Vorlage für jede Richtung. Das Bild ist sein Schnitt bei z = 0.</translation>
    </message>
    <message>
        <source>Match histograms</source>
        <translation>Histogramme angleichen</translation>
    </message>
    <message>
        <source>Matching feature maps</source>
        <translation>Merkmalskarten angleichen</translation>
    </message>
    <message>
        <source>Matching neighbourhoods</source>
        <translation>Nachbarschaften angleichen</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>Maximum</translation>
    </message>
    <message>
        <source>Mirrored</source>
        <translation>Gespiegelt</translation>
    </message>
    <message>
        <source>Mirrored, half</source>
        <translation>Gespiegelt, halb</translation>
    </message>
    <message>
        <source>Mirrored, left</source>
        <translation>Gespiegelt, links</translation>
    </message>
    <message>
        <source>Mirrored, right</source>
        <translation>Gespiegelt, rechts</translation>
    </message>
    <message>
        <source>Move seams</source>
        <translation>Nähte verlegen</translation>
    </message>
    <message>
        <source>Moving seams</source>
        <translation>Nähte werden verlegt</translation>
    </message>
    <message>
        <source>Neighbourhoods</source>
        <translation>Nachbarschaften</translation>
    </message>
    <message>
        <source>Normalised</source>
        <translation>Normiert</translation>
    </message>
    <message>
        <source>Nothing of the image to start from, {} × {} px, is known, so that there is no hole to fill; leave the mask out, or mark what is to be kept.</source>
        <translation>Vom Ausgangsbild, {} × {} px, ist nichts bekannt, sodass es kein Loch zu füllen gibt; lassen Sie die Maske weg oder markieren Sie, was bleiben soll.</translation>
    </message>
    <message>
        <source>Of each direction in one iteration: more make each step surer and longer.</source>
        <translation>Jeder Richtung in einem Durchgang: Mehr machen jeden Schritt sicherer und länger.</translation>
    </message>
    <message>
        <source>Of the slices that are made and compared: larger ones say more of large features, and take longer.</source>
        <translation>Der Schnitte, die gemacht und verglichen werden: Größere sagen mehr über große Merkmale und dauern länger.</translation>
    </message>
    <message>
        <source>Only the patches of slices were compared: the descriptor sees grey pictures and those of three channels.</source>
        <translation>Nur die Ausschnitte der Schnitte wurden verglichen: Der Deskriptor sieht graue Bilder und solche mit drei Kanälen.</translation>
    </message>
    <message>
        <source>Optimised solid</source>
        <translation>Optimierter Körper</translation>
    </message>
    <message>
        <source>Optimiser</source>
        <translation>Optimierer</translation>
    </message>
    <message>
        <source>Orthogonal</source>
        <translation>Orthogonal</translation>
    </message>
    <message>
        <source>Own</source>
        <translation>Eigene</translation>
    </message>
    <message>
        <source>Plain</source>
        <translation>Einfach</translation>
    </message>
    <message>
        <source>Pooling</source>
        <translation>Pooling</translation>
    </message>
    <message>
        <source>Preparing the descriptor</source>
        <translation>Deskriptor vorbereiten</translation>
    </message>
    <message>
        <source>Pursuit</source>
        <translation>Verfolgung</translation>
    </message>
    <message>
        <source>Pyramid histograms</source>
        <translation>Histogramme von Pyramiden</translation>
    </message>
    <message>
        <source>Random filters</source>
        <translation>Zufällige Filter</translation>
    </message>
    <message>
        <source>Random mosaics: three of each</source>
        <translation>Zufallsmosaike: je drei</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Schrittweite</translation>
    </message>
    <message>
        <source>Relative Gram</source>
        <translation>Relative Gram</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Rounds at each scale: more bring the slices closer to the exemplar.</source>
        <translation>Runden auf jeder Stufe: Mehr bringen die Schnitte der Vorlage näher.</translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>Abtastung</translation>
    </message>
    <message>
        <source>Scanning</source>
        <translation>Abtasten</translation>
    </message>
    <message>
        <source>Second</source>
        <translation>Zweite</translation>
    </message>
    <message>
        <source>Side of the neighbourhoods compared in slices at each scale: larger keeps larger structures whole and takes longer.</source>
        <translation>Seite der Nachbarschaften, die in Schnitten auf jeder Stufe verglichen werden: Größere halten größere Strukturen ganz und dauern länger.</translation>
    </message>
    <message>
        <source>Side of the patches that are compared: larger keeps larger structures, smaller varies more. Where a hole is filled, they are half as large again.</source>
        <translation>Seite der verglichenen Patches: größere bewahren größere Strukturen, kleinere variieren mehr. Wo ein Loch gefüllt wird, sind sie um die Hälfte größer.</translation>
    </message>
    <message>
        <source>Side of the slices</source>
        <translation>Seite der Schnitte</translation>
    </message>
    <message>
        <source>Side of the solid</source>
        <translation>Seite des Körpers</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>Schnitte</translation>
    </message>
    <message>
        <source>Slices square to {} are to look like exemplar {}, and there are {}: give it, or choose another one or none.</source>
        <translation>Schnitte senkrecht zu {} sollen wie Vorlage {} aussehen, und es gibt {}: Geben Sie sie an, oder wählen Sie eine andere oder keine.</translation>
    </message>
    <message>
        <source>Solid texture</source>
        <translation>Körpertextur</translation>
    </message>
    <message>
        <source>Square to x</source>
        <translation>Senkrecht zu x</translation>
    </message>
    <message>
        <source>Square to y</source>
        <translation>Senkrecht zu y</translation>
    </message>
    <message>
        <source>Square to z</source>
        <translation>Senkrecht zu z</translation>
    </message>
    <message>
        <source>Statistic</source>
        <translation>Statistik</translation>
    </message>
    <message>
        <source>Steps of training: a few hundred show what becomes of it, some thousands make it sharper. It can be stopped at any time and keeps what it has learned.</source>
        <translation>Schritte des Trainings: Einige hundert zeigen, was daraus wird, einige tausend machen es schärfer. Es kann jederzeit angehalten werden und behält, was es gelernt hat.</translation>
    </message>
    <message>
        <source>Stopped after {} of {} iterations; the generator knows what it had learned by then.</source>
        <translation>Nach {} von {} Durchgängen angehalten; der Generator kann, was er bis dahin gelernt hatte.</translation>
    </message>
    <message>
        <source>Texloom&apos;s own</source>
        <translation>Der von Texloom</translation>
    </message>
    <message>
        <source>The checkpoint does not suit this run: start again without --resume.</source>
        <translation>Der Zwischenstand passt nicht zu diesem Lauf: beginnen Sie ohne --resume von vorn.</translation>
    </message>
    <message>
        <source>The checkpoint holds no solid; start again without it.</source>
        <translation>Der Zwischenstand enthält keinen Körper; ohne ihn neu beginnen.</translation>
    </message>
    <message>
        <source>The checkpoint is of a generator of another size; start again without it.</source>
        <translation>Der Zwischenstand gehört zu einem Generator anderer Größe; ohne ihn neu beginnen.</translation>
    </message>
    <message>
        <source>The descriptor cannot be used: {}.</source>
        <translation>Der Deskriptor ist nicht brauchbar: {}.</translation>
    </message>
    <message>
        <source>The descriptor gives values that are not numbers at its tap {}: its weights are too large.</source>
        <translation>Der Deskriptor ergibt an seinem Abgriff {} Werte, die keine Zahlen sind: seine Gewichte sind zu groß.</translation>
    </message>
    <message>
        <source>The descriptor sees {} channels, and the exemplar has {} with its maps: choose one that sees them all, such as exemplar, random or wavelet.</source>
        <translation>Der Deskriptor sieht {} Kanäle, die Vorlage hat mit ihren Karten {}: wählen Sie einen, der alle sieht, etwa exemplar, random oder wavelet.</translation>
    </message>
    <message>
        <source>The descriptor {} sees {} channels, and the exemplar has {}.</source>
        <translation>Der Deskriptor {} sieht {} Kanäle, die Vorlage hat {}.</translation>
    </message>
    <message>
        <source>The exemplar has {} × {} px here; its sides must have at least {} px.</source>
        <translation>Die Vorlage hat hier {} × {} px; ihre Seiten müssen mindestens {} px haben.</translation>
    </message>
    <message>
        <source>The exemplar of {}×{} px is too small for the network, which needs {} px a side.</source>
        <translation>Die Vorlage von {}×{} px ist zu klein für das Netz, das je Seite {} px braucht.</translation>
    </message>
    <message>
        <source>The first layer of the network that is compared; a larger number leaves fine detail free.</source>
        <translation>Die erste Schicht des Netzes, die verglichen wird; eine größere Zahl lässt feine Einzelheiten frei.</translation>
    </message>
    <message>
        <source>The first tap is {}, and the descriptor has {}: {}.</source>
        <translation>Der erste Abgriff ist {}, der Deskriptor hat {}: {}.</translation>
    </message>
    <message>
        <source>The first tap is {}, which comes after the last, {}.</source>
        <translation>Der erste Abgriff ist {} und liegt hinter dem letzten, {}.</translation>
    </message>
    <message>
        <source>The generator&apos;s array {} holds {}; variances are not below 0.</source>
        <translation>Das Feld {} des Generators enthält {}; Varianzen sind nicht kleiner als 0.</translation>
    </message>
    <message>
        <source>The generator&apos;s shape of {} dimensions, coarsest scale {}, {} channels of noise, steps of {} and {} channels is none that can be evaluated.</source>
        <translation>Die Form des Generators mit {} Dimensionen, gröbster Stufe {}, {} Kanälen Rauschen, Schritten von {} und {} Kanälen kann nicht ausgewertet werden.</translation>
    </message>
    <message>
        <source>The hole of {:.0f} px is larger than the {:.0f} px of the picture that are left to fill it from; mark a smaller one, or add another exemplar.</source>
        <translation>Das Loch von {:.0f} px ist größer als die {:.0f} px des Bilds, die übrig sind, um es zu füllen; markieren Sie ein kleineres oder fügen Sie eine weitere Vorlage hinzu.</translation>
    </message>
    <message>
        <source>The last layer that is compared, or all that there are; a smaller number leaves large structures free and is faster.</source>
        <translation>Die letzte Schicht, die verglichen wird, oder alle, die es gibt; eine kleinere Zahl lässt große Strukturen frei und ist schneller.</translation>
    </message>
    <message>
        <source>The maps of the material have {} × {} and {} × {} px, so that they do not lie on one another; choose maps of one size.</source>
        <translation>Die Karten des Materials haben {} × {} und {} × {} px, sodass sie nicht aufeinanderliegen; wählen Sie Karten einer Größe.</translation>
    </message>
    <message>
        <source>The mesh has no face, so that there is nothing to show a material on; choose another one.</source>
        <translation>Das Netz hat keine Fläche, auf der ein Material gezeigt werden könnte; wählen Sie ein anderes.</translation>
    </message>
    <message>
        <source>The network has no layer for the tap {}.</source>
        <translation>Das Netz hat keine Schicht für den Abgriff {}.</translation>
    </message>
    <message>
        <source>The network whose feature maps are compared: the file that is given, else Texloom&apos;s own; maps beside colours need one that sees them: learned from the exemplar, random or wavelets.</source>
        <translation>Das Netz, dessen Merkmalskarten verglichen werden: die angegebene Datei, sonst das von Texloom; Karten neben den Farben brauchen eines, das sie sieht: aus der Vorlage gelernt, zufällig oder Wavelets.</translation>
    </message>
    <message>
        <source>The solid in space, without end; the picture is its slice at z = 0.</source>
        <translation>Der Körper im Raum, ohne Ende; das Bild ist sein Schnitt bei z = 0.</translation>
    </message>
    <message>
        <source>The solid, which repeats after its side along every axis.</source>
        <translation>Der Körper, der sich nach seiner Seite entlang jeder Achse wiederholt.</translation>
    </message>
    <message>
        <source>The weights of {} do not fit {} channels and a square of odd side, or have no bias.</source>
        <translation>Die Gewichte von {} passen nicht zu {} Kanälen und einem Quadrat ungerader Seite, oder haben keinen Bias.</translation>
    </message>
    <message>
        <source>The weights of {} hold values that are not numbers.</source>
        <translation>Die Gewichte von {} enthalten Werte, die keine Zahlen sind.</translation>
    </message>
    <message>
        <source>The weights of {} lie beyond the end of the file, which holds {} numbers: it is cut short or of another network.</source>
        <translation>Die Gewichte von {} liegen hinter dem Ende der Datei, die {} Zahlen hält: sie ist abgeschnitten oder von einem anderen Netz.</translation>
    </message>
    <message>
        <source>There is no light in this panorama; choose another picture.</source>
        <translation>In diesem Panorama ist kein Licht; wählen Sie ein anderes Bild.</translation>
    </message>
    <message>
        <source>Third</source>
        <translation>Dritte</translation>
    </message>
    <message>
        <source>Total variation</source>
        <translation>Totalvariation</translation>
    </message>
    <message>
        <source>Training</source>
        <translation>Training</translation>
    </message>
    <message>
        <source>Trains a small network on single slices, which then makes any part of an endless solid at once. For grain and blobs that look alike in all directions, and, with one axis free, for what runs along it.</source>
        <translation>Trainiert ein kleines Netz an einzelnen Schnitten, das dann jeden Teil eines endlosen Körpers sofort macht. Für Körnung und Flecken, die in allen Richtungen gleich aussehen, und, mit einer freien Achse, für das, was an ihr entlangläuft.</translation>
    </message>
    <message>
        <source>Turn square to x</source>
        <translation>Drehung senkrecht zu x</translation>
    </message>
    <message>
        <source>Turn square to y</source>
        <translation>Drehung senkrecht zu y</translation>
    </message>
    <message>
        <source>Turn square to z</source>
        <translation>Drehung senkrecht zu z</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Voxels along each axis, after which the solid repeats: twice as many take eight times as long.</source>
        <translation>Voxel entlang jeder Achse, nach denen sich der Körper wiederholt: Doppelt so viele dauern achtmal so lange.</translation>
    </message>
    <message>
        <source>Wavelets</source>
        <translation>Wavelets</translation>
    </message>
    <message>
        <source>Weight of patches</source>
        <translation>Gewicht der Ausschnitte</translation>
    </message>
    <message>
        <source>Weight of the descriptor</source>
        <translation>Gewicht des Deskriptors</translation>
    </message>
    <message>
        <source>Weight square to x</source>
        <translation>Gewicht senkrecht zu x</translation>
    </message>
    <message>
        <source>Weight square to y</source>
        <translation>Gewicht senkrecht zu y</translation>
    </message>
    <message>
        <source>Weight square to z</source>
        <translation>Gewicht senkrecht zu z</translation>
    </message>
    <message>
        <source>What is compared of the feature maps: their moments once each has the exemplar&apos;s mean and deviation, their Gram matrices as published, or these relative to the exemplar&apos;s.</source>
        <translation>Was von den Merkmalskarten verglichen wird: ihre Momente, nachdem jede auf Mittel und Abweichung der Vorlage bezogen ist, ihre Gram-Matrizen wie veröffentlicht, oder diese im Verhältnis zu denen der Vorlage.</translation>
    </message>
    <message>
        <source>What slices look like: one image for all directions, or one each for those square to z, y and x.</source>
        <translation>Wie Schnitte aussehen: ein Bild für alle Richtungen, oder je eines für die senkrecht zu z, y und x.</translation>
    </message>
    <message>
        <source>What slices square to this axis look like. Own is the first exemplar for z, the second for y and the third for x, or the first where there are fewer; of a free axis nothing is wanted, as along the grain of wood.</source>
        <translation>Wie Schnitte senkrecht zu dieser Achse aussehen. Die eigene ist für z die erste Vorlage, für y die zweite und für x die dritte, oder die erste, wo es weniger gibt; von einer freien Achse wird nichts verlangt, wie entlang der Maserung von Holz.</translation>
    </message>
    <message>
        <source>What was learned, under half a megabyte: `texloom-cli sample` makes boxes, slices and coloured meshes of it.</source>
        <translation>Was gelernt wurde, weniger als ein halbes Megabyte: `texloom-cli sample` macht daraus Quader, Schnitte und gefärbte Netze.</translation>
    </message>
    <message>
        <source>Where a hole is filled, moves the borders between what is copied to where they are seen least, so that few large pieces take the place of many small ones.</source>
        <translation>Wo ein Loch gefüllt wird, werden die Grenzen zwischen dem Kopierten dorthin verlegt, wo man sie am wenigsten sieht, sodass wenige große Stücke an die Stelle vieler kleiner treten.</translation>
    </message>
    <message>
        <source>Where a hole is filled, takes the brightness and colour of what is copied from what is around it, so that no border is seen where the light changes; what is known stays as it is. Off: every pixel is a copy.</source>
        <translation>Wo ein Loch gefüllt wird, richten sich Helligkeit und Farbe des Kopierten nach der Umgebung, sodass kein Rand zu sehen ist, wo das Licht sich ändert; was bekannt ist, bleibt, wie es ist. Aus: Jedes Pixel ist eine Kopie.</translation>
    </message>
    <message>
        <source>Writing a turn</source>
        <translation>Eine Umdrehung wird geschrieben</translation>
    </message>
    <message>
        <source>a chain of its network does not end in a tap</source>
        <translation>eine Kette seines Netzes endet nicht mit einem Abgriff</translation>
    </message>
    <message>
        <source>a channel of the file, counted from 0</source>
        <translation>ein Kanal der Datei, von 0 an gezählt</translation>
    </message>
    <message>
        <source>a length from 1 to {}</source>
        <translation>eine Länge von 1 bis {}</translation>
    </message>
    <message>
        <source>its head lacks “{}”</source>
        <translation>seinem Kopf fehlt „{}“</translation>
    </message>
    <message>
        <source>its network has more than {} steps</source>
        <translation>sein Netz hat mehr als {} Schritte</translation>
    </message>
    <message>
        <source>the weights of its layer {} do not fit {} channels and a square of odd side</source>
        <translation>die Gewichte seiner Schicht {} passen nicht zu {} Kanälen und einem Quadrat ungerader Seite</translation>
    </message>
    <message>
        <source>there are no weights for its layer {}</source>
        <translation>für seine Schicht {} gibt es keine Gewichte</translation>
    </message>
    <message>
        <source>{} cannot be read.</source>
        <translation>{} kann nicht gelesen werden.</translation>
    </message>
    <message>
        <source>{} holds more than {} bytes; unpack it first.</source>
        <translation>{} enthält mehr als {} Bytes; entpacken Sie es zuerst.</translation>
    </message>
    <message>
        <source>{} holds no picture that can be opened.</source>
        <translation>{} enthält kein Bild, das geöffnet werden kann.</translation>
    </message>
    <message>
        <source>{} holds {} files, more than {}; unpack it first.</source>
        <translation>{} enthält {} Dateien, mehr als {}; entpacken Sie es zuerst.</translation>
    </message>
    <message>
        <source>{} holds {} pictures; open those that you want.</source>
        <translation>{} enthält {} Bilder; öffnen Sie die gewünschten.</translation>
    </message>
    <message>
        <source>{} in {} is packed in a way that is not read; unpack the archive first.</source>
        <translation>{} in {} ist auf eine Art gepackt, die nicht gelesen wird; entpacken Sie das Archiv zuerst.</translation>
    </message>
    <message>
        <source>{} is a ZIP64 archive, which is not read; unpack it first.</source>
        <translation>{} ist ein ZIP64-Archiv, das nicht gelesen wird; entpacken Sie es zuerst.</translation>
    </message>
    <message>
        <source>{} is broken or no ZIP archive.</source>
        <translation>{} ist beschädigt oder kein ZIP-Archiv.</translation>
    </message>
    <message>
        <source>{} is grey and is taken as coloured, as the others are.</source>
        <translation>{} ist grau und wird als farbig genommen, wie die anderen es sind.</translation>
    </message>
    <message>
        <source>{} is no .json: name the one that lies beside the .bin with the weights.</source>
        <translation>{} ist keine .json: nennen Sie die, die neben der .bin mit den Gewichten liegt.</translation>
    </message>
    <message>
        <source>{} already exists; choose a folder without pictures of an earlier turn.</source>
        <translation>{} gibt es schon; wählen Sie einen Ordner ohne Bilder einer früheren Umdrehung.</translation>
    </message>
    <message>
        <source>{} names no convolution conv1_1: it is no network of VGG&apos;s kind.</source>
        <translation>{} nennt keine Faltung conv1_1: es ist kein Netz von der Art des VGG.</translation>
    </message>
    <message>
        <source>{}: meshes with colours are written as .ply, .obj or .glb.</source>
        <translation>{}: Netze mit Farben werden als .ply, .obj oder .glb geschrieben.</translation>
    </message>
    <message>
        <source>{}: {} vertices want three numbers each, and there are {}.</source>
        <translation>{}: {} Ecken brauchen je drei Zahlen, und es gibt {}.</translation>
    </message>
    <message>
        <source>“pooling” of its head is neither average nor maximum</source>
        <translation>„pooling“ in seinem Kopf ist weder average noch maximum</translation>
    </message>
    <message>
        <source>“{}” in its network means nothing there</source>
        <translation>„{}“ bedeutet in seinem Netz dort nichts</translation>
    </message>
    <message>
        <source>“{}” of its head is no number from {} to {}</source>
        <translation>„{}“ in seinem Kopf ist keine Zahl von {} bis {}</translation>
    </message>
    <message>
        <source>Distributes the patches of all slices as the exemplar&apos;s are, which is sharpest; or matches histograms of pyramids, quick, for grain without shapes; or copies neighbourhoods (Kopf), soft where directions disagree; or makes one voxel after another (Wei).</source>
        <translation>Verteilt die Ausschnitte aller Schnitte wie die der Vorlage, was am schärfsten ist; oder gleicht Histogramme von Pyramiden an, schnell, für Körnung ohne Formen; oder kopiert Nachbarschaften (Kopf), weich, wo Richtungen nicht übereinstimmen; oder macht ein Voxel nach dem anderen (Wei).</translation>
    </message>
    <message>
        <source>Gatys, Ecker and Bethge: plain Gram matrices on one scale and one level from noise, 2,000 iterations at most; give it their VGG-19 as its descriptor.</source>
        <translation>Gatys, Ecker und Bethge: einfache Gram-Matrizen auf einer Skala und einer Stufe aus Rauschen, höchstens 2.000 Iterationen; geben Sie als Deskriptor deren VGG-19.</translation>
    </message>
    <message>
        <source>Gram matrices of several networks</source>
        <translation>Gram-Matrizen mehrerer Netze</translation>
    </message>
    <message>
        <source>Gram matrices, as published</source>
        <translation>Gram-Matrizen, wie veröffentlicht</translation>
    </message>
    <message>
        <source>How many sizes of the picture, each half the one before, the network sees at once: more hold larger structures together; 0 leaves it to the descriptor.</source>
        <translation>Wie viele Größen des Bildes, jede halb so groß wie die vorige, das Netz zugleich sieht: mehr halten größere Strukturen zusammen; 0 überlässt es dem Deskriptor.</translation>
    </message>
    <message>
        <source>Largest of four instead of the mean</source>
        <translation>Der größte von vieren statt des Mittels</translation>
    </message>
    <message>
        <source>The same texture by four descriptors, and by one with the other kind of pooling, as figure 4.8 of Gutierrez&apos; thesis compares them.</source>
        <translation>Dieselbe Textur durch vier Deskriptoren und durch einen mit der anderen Art von Pooling, wie Abbildung 4.8 von Gutierrez&apos; Dissertation sie vergleicht.</translation>
    </message>
    <message>
        <source>Autocorrelations apart</source>
        <translation>Abstand der Autokorrelationen</translation>
    </message>
    <message>
        <source>Contrast kept</source>
        <translation>Erhaltener Kontrast</translation>
    </message>
    <message>
        <source>From the most used part of the exemplar, %</source>
        <translation>Aus dem meistgenutzten Teil der Vorlage, %</translation>
    </message>
    <message>
        <source>How far flat patches are kept from winning in whole outputs where nothing fits well, and parts of one flat colour from growing beyond their share: 1 holds the exemplar&apos;s contrast; 0 compares as published, and outputs may fade.</source>
        <translation>Wie weit flache Patches in ganzen Ausgaben davon abgehalten werden, zu gewinnen, wo nichts gut passt, und einfarbige Teile davon, über ihren Anteil hinaus zu wachsen: 1 hält den Kontrast der Vorlage; 0 vergleicht wie veröffentlicht, und Ausgaben können verblassen.</translation>
    </message>
    <message>
        <source>How much pieces that were copied near by are avoided in whole outputs: larger repeats itself less, but joins worse; 0 takes whatever fits best, as published.</source>
        <translation>Wie sehr in ganzen Ausgaben Stücke gemieden werden, die in der Nähe schon kopiert wurden: größer wiederholt sich weniger, fügt aber schlechter; 0 nimmt, was am besten passt, wie veröffentlicht.</translation>
    </message>
    <message>
        <source>Jump where pieces meet</source>
        <translation>Sprung, wo Stücke sich treffen</translation>
    </message>
    <message>
        <source>Lattice kept</source>
        <translation>Erhaltenes Gitter</translation>
    </message>
    <message>
        <source>Layout</source>
        <translation>Anordnung</translation>
    </message>
    <message>
        <source>Quilted</source>
        <translation>Gequiltet</translation>
    </message>
    <message>
        <source>The settings of Raad &amp; Galerne, IPOL 2017: patches of 40 px, a quarter of overlap, a tolerance of 0.1, contrast not balanced, and pieces used again wherever they fit.</source>
        <translation>Die Einstellungen von Raad &amp; Galerne, IPOL 2017: Patches von 40 px, ein Viertel Überlappung, eine Toleranz von 0,1, Kontrast nicht ausgeglichen, und Stücke wiederverwendet, wo immer sie passen.</translation>
    </message>
    <message>
        <source>The vectors of {} no longer agreed with {} (slopes alike by {:.2f}, in the exemplar by {:.2f}), so they were derived from the heights.</source>
        <translation>Die Vektoren von {} stimmten nicht mehr mit {} überein (Steigungen gleichen sich zu {:.2f}, in der Vorlage zu {:.2f}), daher wurden sie aus den Höhen abgeleitet.</translation>
    </message>
    <message>
        <source>Variety</source>
        <translation>Abwechslung</translation>
    </message>
    <message>
        <source>What an output that is larger than the exemplar, or wraps, is a variant of: a quilt of it, or its mirror images, which show as a kaleidoscope. An initial image takes their place.</source>
        <translation>Wovon eine Ausgabe, die größer als die Vorlage ist oder sich schließt, eine Variante ist: von einem Quilt aus ihr oder von ihren Spiegelbildern, die als Kaleidoskop auffallen. Ein Startbild tritt an ihre Stelle.</translation>
    </message>
    <message>
        <source>{} does not cover the output, so its patches were first laid out by image quilting; give an initial image for a layout of your own.</source>
        <translation>{} deckt die Ausgabe nicht ab, daher wurden seine Patches zuerst durch Bild-Quilting angeordnet; für eine eigene Anordnung ein Startbild angeben.</translation>
    </message>
    <message>
        <source>128 px</source>
        <translation>128 px</translation>
    </message>
    <message>
        <source>256 px</source>
        <translation>256 px</translation>
    </message>
    <message>
        <source>64 px</source>
        <translation>64 px</translation>
    </message>
    <message>
        <source>A scale of {} voxels for a unit of the mesh is none; it must be more than 0.</source>
        <translation>Ein Maßstab von {} Voxeln je Einheit des Netzes ist keiner; er muss größer als 0 sein.</translation>
    </message>
    <message>
        <source>A trained generator to make the texture with, or to train further.</source>
        <translation>Ein trainierter Generator, der die Textur macht oder weiter trainiert wird.</translation>
    </message>
    <message>
        <source>An exemplar with a longer one is scaled down to this, and features with it: larger keeps more detail and takes much longer to learn.</source>
        <translation>Eine Vorlage mit einer längeren wird darauf verkleinert, und ihre Merkmale mit ihr: Größer bewahrt mehr Einzelheiten und lernt sich viel langsamer.</translation>
    </message>
    <message>
        <source>Batch</source>
        <translation>Stapel</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>Beides</translation>
    </message>
    <message>
        <source>Colouring a mesh</source>
        <translation>Ein Netz wird gefärbt</translation>
    </message>
    <message>
        <source>Compare by</source>
        <translation>Vergleichen nach</translation>
    </message>
    <message>
        <source>Decay</source>
        <translation>Abnahme</translation>
    </message>
    <message>
        <source>Decay every</source>
        <translation>Abnahme alle</translation>
    </message>
    <message>
        <source>Even gradients</source>
        <translation>Gradienten ausgleichen</translation>
    </message>
    <message>
        <source>Feature maps that each scale adds, 8 as published: more hold more of the texture, and take longer by their square.</source>
        <translation>Merkmalskarten, die jede Stufe hinzufügt, veröffentlicht 8: Mehr fassen mehr von der Textur und brauchen im Quadrat länger.</translation>
    </message>
    <message>
        <source>Figure 4.3 of Gutierrez&apos; thesis: the same noise through the generator after more and more iterations. First colours, then soft shapes, then edges and detail; the curve of the loss is under Figures.</source>
        <translation>Abbildung 4.3 der Dissertation von Gutierrez: dasselbe Rauschen durch den Generator nach immer mehr Durchläufen. Erst Farben, dann weiche Formen, dann Kanten und Einzelheiten; die Kurve des Verlusts steht unter Kennzahlen.</translation>
    </message>
    <message>
        <source>Figures 4.4 and 4.5 of Gutierrez&apos; thesis: the rate falls by 0.8 now and then, in batches of one or four samples. See the curve of the loss under Figures.</source>
        <translation>Abbildungen 4.4 und 4.5 der Dissertation von Gutierrez: Die Rate fällt ab und zu auf das 0,8-Fache, in Stapeln von einer oder vier Proben. Die Kurve des Verlusts steht unter Kennzahlen.</translation>
    </message>
    <message>
        <source>Figures 4.6 to 4.9 of Gutierrez&apos; thesis in small: the exemplar learned at three sizes, the descriptor&apos;s pooling by mean and by maximum, and gradients as they are or evened out over its taps.</source>
        <translation>Abbildungen 4.6 bis 4.9 der Dissertation von Gutierrez im Kleinen: die Vorlage in drei Größen gelernt, der Deskriptor mit Mittelwert- und mit Maximum-Pooling, und Gradienten, wie sie sind oder über seine Abgriffe ausgeglichen.</translation>
    </message>
    <message>
        <source>Gives the gradient at each tap of the descriptor the same norm, so that all have their say, whatever their loss.</source>
        <translation>Gibt dem Gradienten an jedem Abgriff des Deskriptors dieselbe Norm, damit alle mitreden, wie groß ihr Verlust auch sei.</translation>
    </message>
    <message>
        <source>Goes on training the generator that is given; else it only makes the texture, at once.</source>
        <translation>Trainiert den gegebenen Generator weiter; sonst macht er nur sofort die Textur.</translation>
    </message>
    <message>
        <source>Gradients</source>
        <translation>Gradienten</translation>
    </message>
    <message>
        <source>Halvings</source>
        <translation>Halbierungen</translation>
    </message>
    <message>
        <source>How far each step goes at the beginning. Too large, and the loss jumps; too small, and it falls slowly.</source>
        <translation>Wie weit jeder Schritt am Anfang geht. Zu groß, und der Verlust springt; zu klein, und er fällt langsam.</translation>
    </message>
    <message>
        <source>How often the generator&apos;s noise is halved in size: each scale more lets features be twice as large.</source>
        <translation>Wie oft das Rauschen des Generators auf die halbe Größe gebracht wird: Mit jeder Stufe mehr dürfen Merkmale doppelt so groß sein.</translation>
    </message>
    <message>
        <source>It has rows {:.0f} px apart, so methods that keep rows come first.</source>
        <translation>Es hat Reihen im Abstand von {:.0f} px; deshalb stehen Verfahren vorn, die Reihen erhalten.</translation>
    </message>
    <message>
        <source>It repeats itself every {:.0f} px, so methods that follow a lattice come first.</source>
        <translation>Es wiederholt sich alle {:.0f} px; deshalb stehen Verfahren vorn, die einem Gitter folgen.</translation>
    </message>
    <message>
        <source>Iterations after which the learning rate falls; 0 for a tenth of them all.</source>
        <translation>Durchläufe, nach denen die Lernrate fällt; 0 für ein Zehntel von allen.</translation>
    </message>
    <message>
        <source>Its shapes reach over {:.0f} px of {} × {} px, so methods that keep large pieces come first.</source>
        <translation>Seine Formen reichen über {:.0f} px von {} × {} px; deshalb stehen Verfahren vorn, die große Stücke erhalten.</translation>
    </message>
    <message>
        <source>Making the texture</source>
        <translation>Textur wird gemacht</translation>
    </message>
    <message>
        <source>Noise channels</source>
        <translation>Rauschkanäle</translation>
    </message>
    <message>
        <source>Of the random numbers that each scale begins with.</source>
        <translation>Der Zufallszahlen, mit denen jede Stufe beginnt.</translation>
    </message>
    <message>
        <source>Of the textures that are made and compared in training: larger ones say more of large features, and take longer.</source>
        <translation>Der Texturen, die beim Training gemacht und verglichen werden: Größere sagen mehr über große Merkmale und brauchen länger.</translation>
    </message>
    <message>
        <source>Padding</source>
        <translation>Randfortsetzung</translation>
    </message>
    <message>
        <source>Samples in one iteration: more make each step surer and longer.</source>
        <translation>Proben in einem Durchlauf: Mehr machen jeden Schritt sicherer und länger.</translation>
    </message>
    <message>
        <source>Samples of {} px are too small for the network, which needs {} px a side.</source>
        <translation>Proben von {} px sind zu klein für das Netz, das {} px je Seite braucht.</translation>
    </message>
    <message>
        <source>Side of samples</source>
        <translation>Seite der Proben</translation>
    </message>
    <message>
        <source>Texture network</source>
        <translation>Texturnetz</translation>
    </message>
    <message>
        <source>Texture network, as published</source>
        <translation>Texturnetz, wie veröffentlicht</translation>
    </message>
    <message>
        <source>Texture network: learning rate and batch</source>
        <translation>Texturnetz: Lernrate und Stapel</translation>
    </message>
    <message>
        <source>Texture network: resolution, pooling, gradients</source>
        <translation>Texturnetz: Auflösung, Pooling, Gradienten</translation>
    </message>
    <message>
        <source>Texture network: what training does</source>
        <translation>Texturnetz: was Training bewirkt</translation>
    </message>
    <message>
        <source>The box of {} has {} voxels, and one file holds up to {}; write several boxes, which fit together.</source>
        <translation>Der Quader von {} hat {} Voxel, und eine Datei fasst bis zu {}; schreiben Sie mehrere Quader, die zusammenpassen.</translation>
    </message>
    <message>
        <source>The exemplar has {} channels with its maps; a generator makes at most {}.</source>
        <translation>Die Vorlage hat mit ihren Karten {} Kanäle; ein Generator macht höchstens {}.</translation>
    </message>
    <message>
        <source>The mesh has no face that could be coloured; choose another one.</source>
        <translation>Das Netz hat keine Fläche, die gefärbt werden könnte; wählen Sie ein anderes.</translation>
    </message>
    <message>
        <source>There is neither an exemplar to learn from nor a trained generator to make a texture with.</source>
        <translation>Es gibt weder eine Vorlage, von der zu lernen wäre, noch einen trainierten Generator, der eine Textur macht.</translation>
    </message>
    <message>
        <source>There is no generator to train further: give one, or train a new one.</source>
        <translation>Es gibt keinen Generator, der weiter zu trainieren wäre: einen angeben oder neu trainieren.</translation>
    </message>
    <message>
        <source>Train further</source>
        <translation>Weiter trainieren</translation>
    </message>
    <message>
        <source>Trains a small network until what it makes of noise looks like the exemplar; trained, it makes textures of any size at once. For patterns without strict order.</source>
        <translation>Trainiert ein kleines Netz, bis das, was es aus Rauschen macht, wie die Vorlage aussieht; danach macht es sofort Texturen jeder Größe. Für Muster ohne strenge Ordnung.</translation>
    </message>
    <message>
        <source>Ulyanov et al. as Gutierrez trains them: plain Gram matrices of 256 px, circular padding, batches of four and 5,000 iterations, with the rate falling by 0.8; give it their VGG-19 as its descriptor. Takes hours.</source>
        <translation>Ulyanov u. a., wie Gutierrez sie trainiert: einfache Gram-Matrizen von 256 px, kreisförmige Randfortsetzung, Viererstapel und 5.000 Durchläufe, wobei die Rate auf das 0,8-Fache fällt; als Deskriptor ihr VGG-19 angeben. Dauert Stunden.</translation>
    </message>
    <message>
        <source>What of samples and exemplar is compared: the feature maps of a descriptor, the distribution of small patches, which makes edges sharper, or both.</source>
        <translation>Was von Proben und Vorlage verglichen wird: die Merkmalskarten eines Deskriptors, die Verteilung kleiner Ausschnitte, die Kanten schärfer macht, oder beides.</translation>
    </message>
    <message>
        <source>What samples find beyond their edges in training: more of an endless texture, or their other end, as published. Either generator makes any part of any size, and wraps.</source>
        <translation>Was Proben beim Training jenseits ihrer Ränder finden: mehr von einer endlosen Textur oder, wie veröffentlicht, ihr anderes Ende. Beide Generatoren machen jeden Teil in jeder Größe und schließen sich.</translation>
    </message>
    <message>
        <source>What the learning rate is multiplied by each time that it falls.</source>
        <translation>Womit die Lernrate jedes Mal multipliziert wird, wenn sie fällt.</translation>
    </message>
    <message>
        <source>What was learned, under half a megabyte: given to this method, it makes any size and any part of the texture without training.</source>
        <translation>Was gelernt wurde, unter einem halben Megabyte: Diesem Verfahren gegeben, macht es jede Größe und jeden Teil der Textur ohne Training.</translation>
    </message>
    <message>
        <source>Writing a box</source>
        <translation>Ein Quader wird geschrieben</translation>
    </message>
    <message>
        <source>Writing a slice</source>
        <translation>Ein Schnitt wird geschrieben</translation>
    </message>
    <message>
        <source>It is alike over about {:.0f} px and does not repeat, so methods that join copied pieces come first.</source>
        <translation>Es ist über etwa {:.0f} px hinweg ähnlich und wiederholt sich nicht; deshalb stehen Verfahren vorn, die kopierte Stücke verbinden.</translation>
    </message>
    <message>
        <source>It is grain, alike over no more than {:.0f} px, so methods that keep statistics come first.</source>
        <translation>Es ist Korn, über höchstens {:.0f} px hinweg ähnlich; deshalb stehen Verfahren vorn, die Statistik erhalten.</translation>
    </message>
    <message>
        <source>A region cloned without a seam</source>
        <translation>Ein Bereich, nahtlos eingesetzt</translation>
    </message>
    <message>
        <source>Figures 5.36 to 5.41 of Raad&apos;s thesis on free exemplars: strips of rock, metal and wood in a new order, then squares of rock and metal, squares of two exemplars together, and a chaos mosaic of ballast, each three times.</source>
        <translation>Abbildungen 5.36 bis 5.41 aus Raads Dissertation an freien Vorlagen: Streifen von Fels, Metall und Holz in neuer Folge, dann Quadrate von Fels und Metall, Quadrate zweier Vorlagen zusammen und ein Chaos-Mosaik von Schotter, jeweils dreimal.</translation>
    </message>
    <message>
        <source>Figures 5.43 and 5.44 of Raad&apos;s thesis on free exemplars: of two images, each pixel gets the stronger gradient. The first gives its colours, the second its marks; with free borders, as printed, shades may drift.</source>
        <translation>Abbildungen 5.43 und 5.44 aus Raads Dissertation an freien Vorlagen: Von zwei Bildern bekommt jedes Pixel den stärkeren Gradienten. Das erste gibt seine Farben, das zweite seine Spuren; mit freiem Rand, wie gedruckt, können Helligkeiten abdriften.</translation>
    </message>
    <message>
        <source>Fourier mask: how much the waves count</source>
        <translation>Fourier-Maske: wie viel die Wellen zählen</translation>
    </message>
    <message>
        <source>Graph cuts: three ways to place a patch</source>
        <translation>Graphenschnitt: drei Arten, ein Stück zu legen</translation>
    </message>
    <message>
        <source>Kwatra and others 2003: the exemplar pasted at random, where all of it fits, or where a square of it does; then the worst seams mended more and more often.</source>
        <translation>Kwatra und andere 2003: die Vorlage beliebig eingesetzt, wo sie als Ganzes passt oder wo ein Quadrat von ihr passt; dann die schlimmsten Nähte immer öfter ausgebessert.</translation>
    </message>
    <message>
        <source>Liu, Tsin and Lin 2005 stitch whole tiles along the lattice, beside blocks at random; Liu 2004 draws every tile&apos;s colours anew from the principal components of all of them.</source>
        <translation>Liu, Tsin und Lin 2005 nähen ganze Kacheln längs des Gitters zusammen, daneben zufällige Blöcke; Liu 2004 zieht die Farben jeder Kachel neu aus den Hauptkomponenten aller.</translation>
    </message>
    <message>
        <source>Mixed by gradients: a plain material and one with marks</source>
        <translation>Nach Gradienten gemischt: ein schlichtes Material und eines mit Spuren</translation>
    </message>
    <message>
        <source>Nicoll and others 2005: patches that follow the exemplar&apos;s waves not at all, as much as their overlaps, and more. Rows and columns keep their order over the whole output.</source>
        <translation>Nicoll und andere 2005: Stücke, die den Wellen der Vorlage gar nicht folgen, so sehr wie ihren Überlappungen, und mehr. Reihen und Spalten behalten über die ganze Ausgabe ihre Ordnung.</translation>
    </message>
    <message>
        <source>The middle of one image in another: with its own structure, with the stronger structure of both, and pasted as it is, which shows what the equation does.</source>
        <translation>Die Mitte eines Bildes in einem anderen: mit ihrer eigenen Struktur, mit der stärkeren beider und eingefügt, wie sie ist, was zeigt, was die Gleichung leistet.</translation>
    </message>
    <message>
        <source>Tiles of a regular texture: whole, and varied in colour</source>
        <translation>Kacheln einer regelmäßigen Textur: ganz, und in den Farben verändert</translation>
    </message>
    <message>
        <source>Wang tiles: more colours, more tiles</source>
        <translation>Wang-Kacheln: mehr Farben, mehr Kacheln</translation>
    </message>
    <message>
        <source>{} edits one image and joins no two; leave it to the edits of an exemplar.</source>
        <translation>{} bearbeitet ein Bild und verbindet keine zwei; es gehört zu den Bearbeitungen einer Vorlage.</translation>
    </message>
    <message>
        <source>The checkpoint was written by Texloom {}; this is {}, which may go on otherwise. Start the run again, or use that version.</source>
        <translation>Der Zwischenstand ist von Texloom {}; dies ist {}, das anders weiterrechnen kann. Beginnen Sie den Lauf neu, oder nehmen Sie jene Version.</translation>
    </message>
    <message>
        <source>Training ended after {} of {} iterations, since the next gave values that are not numbers; the generator is that of the last good step. A smaller learning rate may go further.</source>
        <translation>Das Training endete nach {} von {} Durchläufen, weil der nächste Werte ergab, die keine Zahlen sind; der Generator ist der des letzten guten Schritts. Mit kleinerer Lernrate kommt es vielleicht weiter.</translation>
    </message>
    <message>
        <source>Aggregation, fig. 3.14</source>
        <translation>Zusammensetzen, Abb. 3.14</translation>
    </message>
    <message>
        <source>Blended band, fig. 5.12</source>
        <translation>Überblendeter Streifen, Abb. 5.12</translation>
    </message>
    <message>
        <source>Constrained sampling</source>
        <translation>Gebundenes Ziehen</translation>
    </message>
    <message>
        <source>Figure 4.19 of Gutierrez&apos; thesis: the same exemplar wanted square to one axis, to two and to three. What no solid can have from all sides, such as bricks, gets worse with each.</source>
        <translation>Abbildung 4.19 aus Gutierrez’ Dissertation: dieselbe Vorlage quer zu einer, zu zwei und zu drei Achsen verlangt. Was kein Körper von allen Seiten haben kann, etwa Ziegel, wird mit jeder schlechter.</translation>
    </message>
    <message>
        <source>Figure 4.22 of Gutierrez&apos; thesis: one exemplar square to z and another square to the other axes, with their own colours and with those of the first given to both, without which slices cannot agree.</source>
        <translation>Abbildung 4.22 aus Gutierrez’ Dissertation: eine Vorlage quer zu z und eine andere quer zu den übrigen Achsen, mit eigenen Farben und mit denen der ersten für beide, ohne die Schnitte nicht zusammenpassen.</translation>
    </message>
    <message>
        <source>Figure 5.23 of Raad&apos;s thesis: patches of a local Gaussian model alone (LG), then quilted over with pieces of the exemplar (LG+EF), or given the exemplar&apos;s statistics (LG+PS), which brings the grain back.</source>
        <translation>Abbildung 5.23 aus Raads Dissertation: Patches eines lokalen Gauß-Modells allein (LG), dann mit Stücken der Vorlage überlegt (LG+EF) oder auf die Statistik der Vorlage gebracht (LG+PS), was die Körnung zurückbringt.</translation>
    </message>
    <message>
        <source>Figures 3.8 and 3.9 of Raad&apos;s thesis: patches of 10, 20 and 40 px from 10, 50 and 150 neighbours at two scales, then one, two and three scales. More neighbours smooth; one scale alone loses the layout.</source>
        <translation>Abbildungen 3.8 und 3.9 aus Raads Dissertation: Patches von 10, 20 und 40 px aus 10, 50 und 150 Nachbarn in zwei Skalen, dann eine, zwei und drei Skalen. Mehr Nachbarn glätten; eine Skala allein verliert die Anordnung.</translation>
    </message>
    <message>
        <source>Figures 3.8 to 3.18 of Gutierrez&apos; thesis: where patches are taken, how they are put together, how strictly each is used once, how exactly the assignment is solved, and four other methods beside it. The energy of each run is in its curves.</source>
        <translation>Abbildungen 3.8 bis 3.18 aus Gutierrez’ Dissertation: wo Patches genommen, wie sie zusammengesetzt werden, wie streng jedes einmal verwendet, wie genau die Zuordnung gelöst wird, und vier andere Verfahren daneben. Die Energie jedes Laufs zeigen seine Kurven.</translation>
    </message>
    <message>
        <source>Figures 5.2 to 5.13 of López Recas&apos; thesis: the best tile repeated, constrained random sampling and quilting on near-regular exemplars; narrow and wide blended bands; and irregular exemplars, sampled without a lattice.</source>
        <translation>Abbildungen 5.2 bis 5.13 aus López Recas’ Arbeit: die beste Kachel wiederholt, gebundenes Ziehen und Quilting auf fast regelmäßigen Vorlagen; schmale und breite Überblendung; und unregelmäßige Vorlagen, ohne Gitter gezogen.</translation>
    </message>
    <message>
        <source>Figures 9 to 11 of Raad &amp; Galerne (IPOL 2017): each of the three settings is varied while the others keep their published values. Small patches lose the structure, large ones copy verbatim; the position map of each result shows how much.</source>
        <translation>Abbildungen 9 bis 11 aus Raad &amp; Galerne (IPOL 2017): Jede der drei Einstellungen wird verändert, während die anderen ihre veröffentlichten Werte behalten. Kleine Patches verlieren die Struktur, große kopieren wörtlich; wie sehr, zeigt die Positionskarte jedes Ergebnisses.</translation>
    </message>
    <message>
        <source>Grid, fig. 3.12</source>
        <translation>Raster, Abb. 3.12</translation>
    </message>
    <message>
        <source>Irregular, fig. 5.13</source>
        <translation>Unregelmäßig, Abb. 5.13</translation>
    </message>
    <message>
        <source>LG</source>
        <translation>LG</translation>
    </message>
    <message>
        <source>LG+EF</source>
        <translation>LG+EF</translation>
    </message>
    <message>
        <source>LG+PS</source>
        <translation>LG+PS</translation>
    </message>
    <message>
        <source>Locally Gaussian, and what follows it</source>
        <translation>Lokal gaußsch, und was darauf folgt</translation>
    </message>
    <message>
        <source>Multiscale Gaussian: patch, neighbours, scales</source>
        <translation>Mehrskalig gaußsch: Patch, Nachbarn, Skalen</translation>
    </message>
    <message>
        <source>Near-optimal, fig. 3.18</source>
        <translation>Fast optimal, Abb. 3.18</translation>
    </message>
    <message>
        <source>Near-regular textures beside tiles and quilting</source>
        <translation>Fast regelmäßige Texturen neben Kacheln und Quilting</translation>
    </message>
    <message>
        <source>One direction</source>
        <translation>Eine Richtung</translation>
    </message>
    <message>
        <source>Overlap, fig. 10</source>
        <translation>Überlappung, Abb. 10</translation>
    </message>
    <message>
        <source>Patch and neighbours, fig. 3.8</source>
        <translation>Patch und Nachbarn, Abb. 3.8</translation>
    </message>
    <message>
        <source>Patch assignment: grids, aggregation, relaxation, tolerance</source>
        <translation>Patch-Zuordnung: Raster, Zusammensetzen, Lockerung, Toleranz</translation>
    </message>
    <message>
        <source>Patch size, fig. 9</source>
        <translation>Patchgröße, Abb. 9</translation>
    </message>
    <message>
        <source>PatchMatch, fig. 3.13</source>
        <translation>PatchMatch, Abb. 3.13</translation>
    </message>
    <message>
        <source>Portilla–Simoncelli, fig. 3.13</source>
        <translation>Portilla–Simoncelli, Abb. 3.13</translation>
    </message>
    <message>
        <source>Quilting</source>
        <translation>Quilting</translation>
    </message>
    <message>
        <source>Quilting: patch, overlap, tolerance</source>
        <translation>Quilting: Patch, Überlappung, Toleranz</translation>
    </message>
    <message>
        <source>Relaxed, fig. 3.16</source>
        <translation>Gelockert, Abb. 3.16</translation>
    </message>
    <message>
        <source>Scales, fig. 3.9</source>
        <translation>Skalen, Abb. 3.9</translation>
    </message>
    <message>
        <source>Solids: one, two and three directions</source>
        <translation>Körper: eine, zwei und drei Richtungen</translation>
    </message>
    <message>
        <source>Solids: two exemplars</source>
        <translation>Körper: zwei Vorlagen</translation>
    </message>
    <message>
        <source>Solids: which way the exemplar is turned</source>
        <translation>Körper: wie die Vorlage gedreht ist</translation>
    </message>
    <message>
        <source>Sparse, fig. 3.13</source>
        <translation>Dünn besetzt, Abb. 3.13</translation>
    </message>
    <message>
        <source>Texture optimization, fig. 3.13</source>
        <translation>Texturoptimierung, Abb. 3.13</translation>
    </message>
    <message>
        <source>The best tile, repeated</source>
        <translation>Die beste Kachel, wiederholt</translation>
    </message>
    <message>
        <source>Three directions</source>
        <translation>Drei Richtungen</translation>
    </message>
    <message>
        <source>Tolerance, fig. 11</source>
        <translation>Toleranz, Abb. 11</translation>
    </message>
    <message>
        <source>Twice the size, fig. 3.8</source>
        <translation>Doppelte Größe, Abb. 3.8</translation>
    </message>
    <message>
        <source>Two directions</source>
        <translation>Zwei Richtungen</translation>
    </message>
    <message>
        <source>Figure 4.20 of Gutierrez&apos; thesis: the exemplar turned or not in each direction. Turns that agree where slices cross have the smallest loss, which is under Figures.</source>
        <translation>Abbildung 4.20 aus Gutierrez’ Dissertation: die Vorlage in jeder Richtung gedreht oder nicht. Drehungen, die übereinstimmen, wo Schnitte sich kreuzen, haben den kleinsten Verlust; er steht unter Kennzahlen.</translation>
    </message>
    <message>
        <source>The texture is made by the generator that was given, and the exemplar is not looked at; to teach it the exemplar, train it further.</source>
        <translation>Die Textur macht der angegebene Generator; die Vorlage wird nicht angesehen. Damit er sie lernt, trainieren Sie ihn weiter.</translation>
    </message>
    <message>
        <source>16, 81 and 256 tiles of two, three and four colours of corners (Ng and others 2005), the 16 of Cohen and others 2003 with coloured edges, and the 8 of their compact set. What strikes the eye comes back less often the more tiles there are.</source>
        <translation>16, 81 und 256 Kacheln aus zwei, drei und vier Farben der Ecken (Ng und andere 2005), die 16 von Cohen und anderen 2003 mit farbigen Kanten und die 8 ihres kompakten Satzes. Was ins Auge fällt, kehrt umso seltener wieder, je mehr Kacheln es gibt.</translation>
    </message>
    <message>
        <source>A full set has a tile for every combination of colours and can wrap; a compact one has two for whatever is above and to the left.</source>
        <translation>Ein vollständiger Satz hat für jede Kombination von Farben eine Kachel und kann sich schließen; ein kompakter hat zwei für alles, was oben und links liegen kann.</translation>
    </message>
    <message>
        <source>All tiles side by side; those of a full set match there.</source>
        <translation>Alle Kacheln nebeneinander; die eines vollständigen Satzes passen dort zusammen.</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>Kanten</translation>
    </message>
    <message>
        <source>Filling tiles</source>
        <translation>Kacheln werden gefüllt</translation>
    </message>
    <message>
        <source>How much companion maps, such as normals or heights, count where pieces are compared, joined and cut: at 1 as much as the image itself; 0 compares the image alone, and maps follow it.</source>
        <translation>Wie viel Begleitkarten, etwa Normalen oder Höhen, zählen, wo Stücke verglichen, verbunden und geschnitten werden: bei 1 so viel wie das Bild selbst; 0 vergleicht nur das Bild, und die Karten folgen ihm.</translation>
    </message>
    <message>
        <source>How much worse than the best a tile may join itself and still be drawn: 0 takes the best whatever the seed, larger lets seeds differ.</source>
        <translation>Wie viel schlechter als die beste eine Kachel an sich anschließen darf, um noch gezogen zu werden: 0 nimmt bei jedem Startwert die beste, mehr lässt sie sich nach dem Startwert unterscheiden.</translation>
    </message>
    <message>
        <source>Kinds of corners, or of edges on each axis: more make more tiles, which repeat less and are harder to cut well.</source>
        <translation>Arten von Ecken, oder von Kanten je Achse: Mehr ergeben mehr Kacheln, die sich weniger wiederholen und schwerer gut zu schneiden sind.</translation>
    </message>
    <message>
        <source>Makes a small set of tiles that match by colours, and lays them without a period. Outputs of any size come in an instant, and any part of them alone; the set can be used by itself. Suits what has no large objects.</source>
        <translation>Macht einen kleinen Satz von Kacheln, die nach Farben zusammenpassen, und legt sie ohne Periode. Ausgaben jeder Größe kommen sofort, auch jeder Teil für sich; der Satz lässt sich allein verwenden. Eignet sich für Texturen ohne große Objekte.</translation>
    </message>
    <message>
        <source>Match</source>
        <translation>Was passt</translation>
    </message>
    <message>
        <source>The colours of every tile&apos;s edges and corners, its place on the sheet, and the tile for each combination of colours; as .json for other programs.</source>
        <translation>Die Farben der Kanten und Ecken jeder Kachel, ihr Platz auf dem Bogen und die Kachel zu jeder Kombination von Farben; als .json für andere Programme.</translation>
    </message>
    <message>
        <source>The first image is {} × {} px, the second {} × {} px: both are cropped to {} × {} px from the top left.</source>
        <translation>Das erste Bild hat {} × {} px, das zweite {} × {} px: Beide werden von oben links aus auf {} × {} px beschnitten.</translation>
    </message>
    <message>
        <source>The place that each pixel comes from, along the axis, with a grey line for what does not move, as in figure 5.30 of the thesis; of turbulence, squares as they are deformed.</source>
        <translation>Die Stelle, von der jedes Pixel kommt, entlang der Achse, mit einer grauen Linie für das, was sich nicht bewegt, wie in Abbildung 5.30 der Dissertation; bei Turbulenz Quadrate, wie sie verformt werden.</translation>
    </message>
    <message>
        <source>The tiles of Cohen, Shade, Hiller &amp; Deussen 2003: edges of two colours on each axis, four samples in diamonds, the 16 tiles of a full set.</source>
        <translation>Die Kacheln von Cohen, Shade, Hiller &amp; Deussen 2003: Kanten in zwei Farben je Achse, vier Proben als Rauten, die 16 Kacheln eines vollständigen Satzes.</translation>
    </message>
    <message>
        <source>Wang tiles, as published</source>
        <translation>Wang-Kacheln, wie veröffentlicht</translation>
    </message>
    <message>
        <source>Weight of companion maps</source>
        <translation>Kartengewicht</translation>
    </message>
    <message>
        <source>What has colours: corners, with fresh texture inside each tile, repeat less; edges are as published first, each tile four samples in diamonds.</source>
        <translation>Was Farben hat: Ecken, mit frischer Textur im Innern jeder Kachel, wiederholen sich weniger; Kanten sind wie zuerst veröffentlicht, jede Kachel vier Proben als Rauten.</translation>
    </message>
    <message>
        <source>What the run starts from has no companion maps, so their weight had no effect.</source>
        <translation>Wovon der Lauf ausgeht, hat keine Begleitkarten, daher blieb ihr Gewicht ohne Wirkung.</translation>
    </message>
    <message>
        <source>Width of the zone in which the cuts may run, as a share of the tile: wider joins better.</source>
        <translation>Breite der Zone, in der die Schnitte verlaufen dürfen, als Anteil der Kachel: Breiter fügt besser zusammen.</translation>
    </message>
    <message>
        <source>a picture to blend</source>
        <translation>ein Bild, das überblendet wird</translation>
    </message>
    <message>
        <source>a source of a run that waits</source>
        <translation>woraus ein wartender Lauf entsteht</translation>
    </message>
    <message>
        <source>a source of the result that is shown</source>
        <translation>woraus das gezeigte Ergebnis entsteht</translation>
    </message>
    <message>
        <source>blend</source>
        <translation>Überblendung</translation>
    </message>
    <message>
        <source>contact sheet</source>
        <translation>Kontaktbogen</translation>
    </message>
    <message>
        <source>open here</source>
        <translation>hier geöffnet</translation>
    </message>
    <message>
        <source>part of the volume</source>
        <translation>Teil des Volumens</translation>
    </message>
    <message>
        <source>picture of the material</source>
        <translation>Bild des Materials</translation>
    </message>
    <message>
        <source>picture of the turn</source>
        <translation>Bild der Drehung</translation>
    </message>
    <message>
        <source>the mesh that the material is shown on</source>
        <translation>das Netz, auf dem das Material gezeigt wird</translation>
    </message>
    <message>
        <source>the mesh that the volume is shown on</source>
        <translation>das Netz, auf dem das Volumen gezeigt wird</translation>
    </message>
    <message>
        <source>the panorama that lights the material</source>
        <translation>das Panorama, das das Material beleuchtet</translation>
    </message>
    <message>
        <source>the session that is open</source>
        <translation>die geöffnete Sitzung</translation>
    </message>
    <message>
        <source>the volume that is open</source>
        <translation>das geöffnete Volumen</translation>
    </message>
    <message>
        <source>{} breaks off before its end marker, but all of its rows are there.</source>
        <translation>{} bricht vor der Endmarke ab, aber alle Zeilen sind da.</translation>
    </message>
    <message>
        <source>{} breaks off before the last of its scans, so that its picture lacks detail or colours; take a whole copy of it.</source>
        <translation>{} bricht vor dem letzten seiner Durchgänge ab, sodass dem Bild Einzelheiten oder Farben fehlen; nehmen Sie eine vollständige Kopie.</translation>
    </message>
    <message>
        <source>{} goes into {}, which takes no picture, so it has no layer {}.</source>
        <translation>{0} kommt in „{1}“, das kein Bild nimmt; eine Ebene {2} gibt es dort nicht.</translation>
    </message>
    <message>
        <source>{} holds data, but is compressed with loss ({}), which changes them; save such maps as PNG, or as EXR or TIFF with zip.</source>
        <translation>{0} enthält Daten, ist aber verlustbehaftet komprimiert ({1}), was sie verändert; speichern Sie solche Karten als PNG, oder als EXR oder TIFF mit zip.</translation>
    </message>
    <message>
        <source>{} is there, and Texloom did not write it; choose another name or folder.</source>
        <translation>{} ist schon da, und Texloom hat es nicht geschrieben; wählen Sie einen anderen Namen oder Ordner.</translation>
    </message>
    <message>
        <source>The mask leaves no whole neighbourhood of {} px, but only some of at most {} px; choose a smaller one or mask less.</source>
        <translation>Die Maske lässt keine ganze Umgebung von {} px übrig, nur welche von höchstens {} px; wählen Sie eine kleinere oder maskieren Sie weniger.</translation>
    </message>
    <message>
        <source>The mask leaves no whole patch of {} px to copy, but only some of at most {} px; choose a smaller patch or mask less.</source>
        <translation>Die Maske lässt keinen ganzen Patch von {} px zum Kopieren, nur welche von höchstens {} px; wählen Sie einen kleineren Patch, oder maskieren Sie weniger.</translation>
    </message>
    <message>
        <source>Where a hole is filled with the stitch cut, moves the borders between what is copied to where they are seen least.</source>
        <translation>Wo ein Loch mit der Naht cut gefüllt wird, werden die Grenzen zwischen dem Kopierten dorthin verlegt, wo man sie am wenigsten sieht.</translation>
    </message>
    <message>
        <source>Where a hole is filled with the stitch cut, takes the brightness and colour of what is copied from what is around it, as the stitch poisson does; off: every pixel is a copy.</source>
        <translation>Wo ein Loch mit der Naht cut gefüllt wird, richten sich Helligkeit und Farbe des Kopierten nach der Umgebung, wie bei der Naht poisson; aus: Jedes Pixel ist eine Kopie.</translation>
    </message>
    <message>
        <source>1 channel</source>
        <translation>1 Kanal</translation>
    </message>
    <message>
        <source>Picture A of {} has {} and picture B {}; they need the same number.</source>
        <translation>Bild A von {} hat {}, Bild B {}; beide brauchen gleich viele.</translation>
    </message>
    <message>
        <source>The dictionary was learnt from {}, and the exemplar with its companions has {}; they need the same number.</source>
        <translation>Das Wörterbuch wurde für {} gelernt, und die Vorlage mit ihren Begleitkarten hat {}; beide müssen gleich viele haben.</translation>
    </message>
    <message>
        <source>The first image has {}, the second {}; they must have the same.</source>
        <translation>Das erste Bild hat {}, das zweite {}; es müssen gleich viele sein.</translation>
    </message>
    <message>
        <source>The generator makes {}, and the exemplar has {}.</source>
        <translation>Der Generator macht {}, und die Vorlage hat {}.</translation>
    </message>
    <message>
        <source>The generator makes {}, and the exemplars have {}.</source>
        <translation>Der Generator macht {}, und die Vorlagen haben {}.</translation>
    </message>
    <message>
        <source>The image to start from has {}, the output {}; they need the same number.</source>
        <translation>Das Startbild hat {}, die Ausgabe {}; beide brauchen gleich viele.</translation>
    </message>
    <message>
        <source>The target has {}, but the picture that corresponds to it for {} has {}; they are compared channel by channel, so give pictures of one kind.</source>
        <translation>Das Ziel hat {}, aber das Bild, das ihm bei {} entspricht, hat {}; sie werden Kanal für Kanal verglichen, bitte Bilder einer Art geben.</translation>
    </message>
    <message>
        <source>The target has {}, the exemplar {}; they need the same number.</source>
        <translation>Das Ziel hat {}, die Vorlage {}; es müssen gleich viele sein.</translation>
    </message>
    <message>
        <source>repeats after {} voxels, {}</source>
        <translation>wiederholt sich nach {} Voxeln, {}</translation>
    </message>
    <message>
        <source>without end, {}</source>
        <translation>ohne Ende, {}</translation>
    </message>
    <message>
        <source>{} channels</source>
        <translation>{} Kanäle</translation>
    </message>
    <message>
        <source>{} has {}; there is no channel {}.</source>
        <translation>{} hat {}; einen Kanal {} gibt es nicht.</translation>
    </message>
    <message>
        <source>{} is {} × {} px with {}; the volume&apos;s first slice {} is {} × {} px with {}.</source>
        <translation>{} ist {} × {} px groß und hat {}; der erste Schnitt {} des Volumens ist {} × {} px groß und hat {}.</translation>
    </message>
    <message>
        <source>{} needs its input {}, which was not given.</source>
        <translation>{} braucht die Eingabe {}, die nicht gegeben wurde.</translation>
    </message>
    <message>
        <source>{} voxels, {}</source>
        <translation>{} Voxel, {}</translation>
    </message>
    <message>
        <source>8 or 16</source>
        <translation>8 oder 16</translation>
    </message>
    <message>
        <source>A file of the export preset has no word for $map.</source>
        <translation>Eine Datei der Export-Vorgabe hat kein Wort für $map.</translation>
    </message>
    <message>
        <source>How much a small tile that repeats often is preferred to a large one that fits better when a lattice is looked for: 1 not at all, larger finds smaller tiles.</source>
        <translation>Wie sehr bei der Suche nach einem Gitter eine kleine Kachel, die sich oft wiederholt, einer großen vorgezogen wird, die besser passt: 1 gar nicht, größer findet kleinere Kacheln.</translation>
    </message>
    <message>
        <source>Overlap that counts</source>
        <translation>Zählende Überlappung</translation>
    </message>
    <message>
        <source>Smaller tiles</source>
        <translation>Kleinere Kacheln</translation>
    </message>
    <message>
        <source>The export preset is of format {}, made by a newer Texloom; this one ({}) reads up to {}.</source>
        <translation>Die Export-Vorgabe hat Format {}, von einem neueren Texloom; dieses ({}) liest bis {}.</translation>
    </message>
    <message>
        <source>The export preset needs a name.</source>
        <translation>Die Export-Vorgabe braucht einen Namen.</translation>
    </message>
    <message>
        <source>The names of files need $map, so that the maps&apos; names differ.</source>
        <translation>Die Dateinamen brauchen $map, damit die Karten verschieden heißen.</translation>
    </message>
    <message>
        <source>The names of files need a letter or a word, such as $name.</source>
        <translation>Die Dateinamen brauchen einen Buchstaben oder ein Wort wie $name.</translation>
    </message>
    <message>
        <source>The share of a tile by which the exemplar must overlap itself for a repetition to count when a lattice is looked for: smaller counts those near its ends, which tell less, and finds larger tiles.</source>
        <translation>Der Anteil einer Kachel, um den die Vorlage sich selbst überlappen muss, damit bei der Suche nach einem Gitter eine Wiederholung zählt: kleiner zählt auch die nahe den Rändern, die weniger sagen, und findet größere Kacheln.</translation>
    </message>
    <message>
        <source>Two files of the export preset have the word {} for $map; give them different ones.</source>
        <translation>Zwei Dateien der Export-Vorgabe haben das Wort {} für $map; geben Sie ihnen verschiedene.</translation>
    </message>
    <message>
        <source>as-they-are, up or down</source>
        <translation>as-they-are, up oder down</translation>
    </message>
    <message>
        <source>export preset</source>
        <translation>Export-Vorgabe</translation>
    </message>
    <message>
        <source>{} holds a slash, which no file&apos;s name can.</source>
        <translation>{} enthält einen Schrägstrich, was kein Dateiname darf.</translation>
    </message>
    <message>
        <source>{} would be overwritten by the {}: it is {}; name another file.</source>
        <translation>{0} würde überschrieben ({1}), und es ist {2}; nennen Sie eine andere Datei.</translation>
    </message>
    <message>
        <source>Bounded</source>
        <translation>Begrenzt</translation>
    </message>
    <message>
        <source>Continues what is there: every patch is drawn from the Gaussian of similar ones, given the pixels next to it. Suits grain, gravel and brick; patches are not stitched, so that their borders show on smooth objects such as scales or roof tiles.</source>
        <translation>Setzt fort, was da ist: Jeder Patch wird aus der Gauß-Verteilung ähnlicher gezogen, bedingt durch die Pixel neben ihm. Für Körniges, Kies und Ziegel; Patches werden nicht zusammengefügt, sodass ihre Ränder auf glatten Objekten wie Schuppen oder Dachziegeln zu sehen sind.</translation>
    </message>
    <message>
        <source>Given border</source>
        <translation>Gegebener Rand</translation>
    </message>
    <message>
        <source>How far flat patches are kept from winning where nothing fits well, and how far a sample gets the contrast of the patches that it is drawn from: 1 holds the exemplar&apos;s contrast; 0 is as published, and outputs fade.</source>
        <translation>Wie weit flaue Patches davon abgehalten werden zu gewinnen, wo nichts gut passt, und wie weit eine Ziehung den Kontrast der Patches bekommt, aus denen sie gezogen wird: 1 hält den Kontrast der Vorlage; 0 ist wie veröffentlicht, und Ergebnisse verflachen.</translation>
    </message>
    <message>
        <source>How wide a border of what is there a patch is drawn to continue: narrow keeps the exemplar&apos;s contrast, wide fits more closely and fades; 0 gives all of it, as published.</source>
        <translation>Wie breit der Rand dessen ist, was da ist, den ein Patch fortsetzt: schmal hält den Kontrast der Vorlage, breit passt genauer und verflacht; 0 gibt alles vor, wie veröffentlicht.</translation>
    </message>
    <message>
        <source>Keeps each pixel of a new patch within the lightness and colour that the patches like it have there: no sparks and no false colours. Off: the Gaussian as published.</source>
        <translation>Hält jedes Pixel eines neuen Patches in der Helligkeit und Farbe, die ähnliche Patches dort haben: keine Funken und keine falschen Farben. Aus: die Gauß-Verteilung wie veröffentlicht.</translation>
    </message>
    <message>
        <source>It was left out when Texloom was built; build it with -DTEXLOOM_NETWORKS=ON.</source>
        <translation>Sie wurde beim Bau von Texloom ausgelassen; bauen Sie es mit -DTEXLOOM_NETWORKS=ON.</translation>
    </message>
    <message>
        <source>No lattice was found in {} (confidence {:.0f} %; a vector must fit about twice), so it was treated as a texture that does not repeat. If it does, rectify it where it is seen at an angle, or give its vectors yourself; if it does not, image quilting may suit it better.</source>
        <translation>In {} wurde kein Gitter gefunden (Sicherheit {:.0f} %; ein Vektor muss etwa zweimal hineinpassen), sodass es als Textur ohne Wiederholung behandelt wurde. Wiederholt sie sich doch, entzerren Sie sie, wo sie schräg zu sehen ist, oder geben Sie ihre Vektoren selbst an; wenn nicht, passt Bild-Quilting vielleicht besser.</translation>
    </message>
    <message>
        <source>Nothing in {} repeats about twice, so it was treated as a texture that does not repeat. If it does, rectify it where it is seen at an angle, or give its vectors yourself; if it does not, image quilting may suit it better.</source>
        <translation>Nichts in {} wiederholt sich etwa zweimal, sodass es als Textur ohne Wiederholung behandelt wurde. Wiederholt sie sich doch, entzerren Sie sie, wo sie schräg zu sehen ist, oder geben Sie ihre Vektoren selbst an; wenn nicht, passt Bild-Quilting vielleicht besser.</translation>
    </message>
    <message>
        <source>Nothing in {} repeats, but rows run through all of it: they keep the order that they have there, and begin again every {:.0f} px. If it does repeat, rectify it where it is seen at an angle, or give its vectors yourself.</source>
        <translation>Nichts in {} wiederholt sich, aber Reihen laufen durch alles hindurch: Sie behalten die Reihenfolge, die sie dort haben, und beginnen alle {:.0f} px von vorn. Wiederholt es sich doch, entzerren Sie es, wo es schräg zu sehen ist, oder geben Sie seine Vektoren selbst an.</translation>
    </message>
    <message>
        <source>At most so many, each half the size of the one before: a finer one sees the coarser one&apos;s result where it has made nothing yet, so that large structures are kept, and what grows from opposite sides meets. 1 grows as published.</source>
        <translation>Höchstens so viele, jede halb so groß wie die vorige: Eine feinere sieht das Ergebnis der gröberen, wo sie selbst noch nichts gemacht hat, sodass große Strukturen erhalten bleiben und zusammenpasst, was von gegenüberliegenden Seiten wächst. 1 wächst wie veröffentlicht.</translation>
    </message>
    <message>
        <source>Compares all windows exactly, or only those that are likely by their principal components, in time that hardly grows with the exemplar. Automatic: all on the coarsest scale, or the likely ones of large exemplars, and on finer scales those near the coarser one&apos;s sources.</source>
        <translation>Vergleicht alle Fenster genau oder nur die, die nach ihren Hauptkomponenten in Frage kommen, in einer Zeit, die kaum mit der Vorlage wächst. Automatisch: auf der gröbsten Skala alle oder bei großen Vorlagen die wahrscheinlichen, und auf feineren Skalen die bei den Quellen der gröberen.</translation>
    </message>
    <message>
        <source>Efros–Leung, as published</source>
        <translation>Efros–Leung, wie veröffentlicht</translation>
    </message>
    <message>
        <source>Grows the output pixel by pixel, from coarse to fine; each becomes one of the exemplar&apos;s whose surroundings fit what is around it. Faithful to small structures and large ones. With one scale, as published, it is slow, and a window of the wrong size grows garbage or copies verbatim.</source>
        <translation>Lässt das Ergebnis Pixel für Pixel wachsen, von grob nach fein; jedes wird eines der Vorlage, dessen Umgebung zu dem passt, was um es ist. Treu bei kleinen Strukturen und bei großen. Mit einer Skala, wie veröffentlicht, ist es langsam, und ein Fenster von falscher Größe lässt Unsinn wachsen oder kopiert wörtlich.</translation>
    </message>
    <message>
        <source>Moves the borders between what is copied to where they are seen least, so that few large pieces take the place of many small ones; where a whole output grows, on coarse scales only.</source>
        <translation>Verschiebt die Grenzen zwischen dem, was kopiert ist, dorthin, wo man sie am wenigsten sieht, sodass wenige große Stücke an die Stelle vieler kleiner treten; wo ein ganzes Ergebnis wächst, nur auf groben Skalen.</translation>
    </message>
    <message>
        <source>The settings of Efros &amp; Leung, ICCV 1999, as Aguerrebere, Gousseau &amp; Tartavel give them (IPOL 2013): one scale, windows of 11 px, a tolerance of 0.1 and weights of 1 / 6.4 of the window.</source>
        <translation>Die Einstellungen von Efros &amp; Leung, ICCV 1999, wie Aguerrebere, Gousseau &amp; Tartavel sie angeben (IPOL 2013): eine Skala, Fenster von 11 px, eine Toleranz von 0,1 und Gewichte von 1 / 6,4 des Fensters.</translation>
    </message>
    <message>
        <source>Figures 2.1, 2.4 and 2.5 of Raad&apos;s thesis: patches of 10, 20 and 30 px from 10, 20 and 30 neighbours, replaced in the exemplar itself, then grown; and maps of where each pixel comes from, in which a copied piece is a smooth patch of colour.</source>
        <translation>Abbildungen 2.1, 2.4 und 2.5 aus Raads Dissertation: Patches von 10, 20 und 30 px aus 10, 20 und 30 Nachbarn, erst in der Vorlage selbst ersetzt, dann gewachsen; dazu Karten, woher jedes Pixel stammt, in denen ein kopiertes Stück eine glatte Farbfläche ist.</translation>
    </message>
    <message>
        <source>Gaussian patches: patch and neighbours</source>
        <translation>Gauß-Patches: Patch und Nachbarn</translation>
    </message>
    <message>
        <source>Grown, fig. 2.4</source>
        <translation>Gewachsen, Abb. 2.4</translation>
    </message>
    <message>
        <source>Locally Gaussian and its map, fig. 2.5</source>
        <translation>Lokal gaußsch und seine Karte, Abb. 2.5</translation>
    </message>
    <message>
        <source>Patches replaced, fig. 2.1</source>
        <translation>Patches ersetzt, Abb. 2.1</translation>
    </message>
    <message>
        <source>Quilting and its map, fig. 2.5</source>
        <translation>Quilting und seine Karte, Abb. 2.5</translation>
    </message>
    <message>
        <source>At the finest scale, and up to four times as many at coarser ones: more bring the patches closer to the exemplar&apos;s.</source>
        <translation>Auf der feinsten Skala, und bis zu viermal so viele auf gröberen: mehr bringen die Patches näher an die der Vorlage.</translation>
    </message>
</context>
<context>
    <name>files</name>
    <message>
        <source>Pictures, materials and recipes (%1 *.zip *.json);;All files (*)</source>
        <translation>Bilder, Materialien und Rezepte (%1 *.zip *.json);;Alle Dateien (*)</translation>
    </message>
</context>
<context>
    <name>main</name>
    <message>
        <source>A workbench for exemplar-based texture synthesis.</source>
        <translation>Eine Werkbank für Textursynthese nach Vorlagen.</translation>
    </message>
    <message>
        <source>Exemplars, a recipe or a session to open.</source>
        <translation>Vorlagen, ein Rezept oder eine Sitzung zum Öffnen.</translation>
    </message>
</context>
<context>
    <name>texloom::ui</name>
    <message>
        <source>%1 · seed %2 · %3</source>
        <translation>%1 · Startwert %2 · %3</translation>
    </message>
    <message>
        <source>seed %1</source>
        <translation>Startwert %1</translation>
    </message>
    <message>
        <source>preview</source>
        <translation>Vorschau</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>Exemplars</source>
        <translation>Vorlagen</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Startwert</translation>
    </message>
    <message>
        <source>Made</source>
        <translation>Entstanden</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>on</source>
        <translation>ein</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>%1 at %2, %3</source>
        <translation>%1 bei %2, %3</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Angehalten</translation>
    </message>
    <message>
        <source>at %1 of the work</source>
        <translation>bei %1 der Arbeit</translation>
    </message>
    <message>
        <source>It cannot go on, since these files changed after it began: %1.</source>
        <translation>Er kann nicht fortgesetzt werden, da sich diese Dateien seit seinem Beginn geändert haben: %1.</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>from %1</source>
        <translation>aus %1</translation>
    </message>
</context>
<context>
    <name>texloom::ui::Actions</name>
    <message>
        <source>&amp;Open…</source>
        <translation>Ö&amp;ffnen …</translation>
    </message>
    <message>
        <source>Open exemplars or a recipe</source>
        <translation>Vorlagen oder ein Rezept öffnen</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>&amp;Einfügen</translation>
    </message>
    <message>
        <source>Paste a picture or a file as an exemplar</source>
        <translation>Ein Bild oder eine Datei als Vorlage einfügen</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>E&amp;xportieren …</translation>
    </message>
    <message>
        <source>Write the result and its maps to files</source>
        <translation>Das Ergebnis und seine Karten in Dateien schreiben</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>&amp;Copy result</source>
        <translation>Ergebnis &amp;kopieren</translation>
    </message>
    <message>
        <source>Copy the result as a picture</source>
        <translation>Das Ergebnis als Bild kopieren</translation>
    </message>
    <message>
        <source>Set &amp;mask…</source>
        <translation>&amp;Maske setzen …</translation>
    </message>
    <message>
        <source>&amp;Clear mask</source>
        <translation>Maske &amp;löschen</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>Entfe&amp;rnen</translation>
    </message>
    <message>
        <source>Take the exemplar off the list; its file stays</source>
        <translation>Die Vorlage von der Liste nehmen; ihre Datei bleibt</translation>
    </message>
    <message>
        <source>E&amp;dit…</source>
        <translation>&amp;Bearbeiten …</translation>
    </message>
    <message>
        <source>Crop, turn, rectify, even out the light, hide parts</source>
        <translation>Zuschneiden, drehen, entzerren, Licht ausgleichen, Teile verbergen</translation>
    </message>
    <message>
        <source>Add companion &amp;maps…</source>
        <translation>Begleit&amp;karten hinzufügen …</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>&amp;Ausführen</translation>
    </message>
    <message>
        <source>Make the result; if a run is under way, right after it, but a quick preview gives way</source>
        <translation>Das Ergebnis erzeugen; läuft schon etwas, gleich danach, doch eine Schnellvorschau macht Platz</translation>
    </message>
    <message>
        <source>&amp;Add to queue</source>
        <translation>In die &amp;Warteschlange</translation>
    </message>
    <message>
        <source>Make the result with these settings after all runs that wait</source>
        <translation>Das Ergebnis mit diesen Einstellungen nach allem Wartenden erzeugen</translation>
    </message>
    <message>
        <source>&amp;Quick</source>
        <translation>&amp;Schnell</translation>
    </message>
    <message>
        <source>Make a small preview with the same settings</source>
        <translation>Eine kleine Vorschau mit denselben Einstellungen erzeugen</translation>
    </message>
    <message>
        <source>&amp;New seed and run</source>
        <translation>&amp;Neuer Startwert und ausführen</translation>
    </message>
    <message>
        <source>Reset all &amp;parameters</source>
        <translation>Alle &amp;Parameter zurücksetzen</translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation>Ein&amp;passen</translation>
    </message>
    <message>
        <source>Fit the picture in the view</source>
        <translation>Das Bild in die Ansicht einpassen</translation>
    </message>
    <message>
        <source>&amp;100 %</source>
        <translation>&amp;100 %</translation>
    </message>
    <message>
        <source>One screen pixel for each of the picture&apos;s</source>
        <translation>Ein Bildschirmpixel für jedes des Bildes</translation>
    </message>
    <message>
        <source>Zoom &amp;in</source>
        <translation>Ver&amp;größern</translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation>Ver&amp;kleinern</translation>
    </message>
    <message>
        <source>&amp;Repeat</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>Show the picture repeated on all sides</source>
        <translation>Das Bild nach allen Seiten wiederholt zeigen</translation>
    </message>
    <message>
        <source>R&amp;esult</source>
        <translation>&amp;Ergebnis</translation>
    </message>
    <message>
        <source>&amp;Synthesis map</source>
        <translation>&amp;Synthesekarte</translation>
    </message>
    <message>
        <source>&amp;Position map</source>
        <translation>&amp;Positionskarte</translation>
    </message>
    <message>
        <source>Reset &amp;layout</source>
        <translation>A&amp;nordnung zurücksetzen</translation>
    </message>
    <message>
        <source>F&amp;ull screen</source>
        <translation>&amp;Vollbild</translation>
    </message>
    <message>
        <source>&amp;Keyboard shortcuts</source>
        <translation>&amp;Tastenkürzel</translation>
    </message>
    <message>
        <source>&amp;About Texloom</source>
        <translation>&amp;Über Texloom</translation>
    </message>
    <message>
        <source>&amp;Copied pieces</source>
        <translation>&amp;Kopierte Stücke</translation>
    </message>
    <message>
        <source>&amp;Lattice</source>
        <translation>&amp;Gitter</translation>
    </message>
    <message>
        <source>Find or set the vectors by which the exemplar repeats itself</source>
        <translation>Die Vektoren finden oder setzen, um die sich die Vorlage wiederholt</translation>
    </message>
    <message>
        <source>&amp;Blend two images…</source>
        <translation>Zwei Bilder über&amp;blenden …</translation>
    </message>
    <message>
        <source>Join two images along a curve</source>
        <translation>Zwei Bilder entlang einer Kurve verbinden</translation>
    </message>
    <message>
        <source>Patch &amp;variance…</source>
        <translation>Patch&amp;varianz …</translation>
    </message>
    <message>
        <source>How much patches vary that are alike, by their size and number</source>
        <translation>Wie stark ähnliche Patches schwanken, nach Größe und Zahl</translation>
    </message>
    <message>
        <source>&amp;Half offset</source>
        <translation>&amp;Halb versetzt</translation>
    </message>
    <message>
        <source>Show the picture repeated, with the corner where its tiles meet in the middle</source>
        <translation>Das Bild wiederholt zeigen, mit der Ecke, an der sich die Kacheln treffen, in der Mitte</translation>
    </message>
    <message>
        <source>&amp;Stress test…</source>
        <translation>&amp;Belastungsprobe …</translation>
    </message>
    <message>
        <source>Make a texture of the texture of the texture, to see what the method loses</source>
        <translation>Eine Textur der Textur der Textur machen, um zu sehen, was das Verfahren verliert</translation>
    </message>
    <message>
        <source>&amp;Stop and keep</source>
        <translation>An&amp;halten und behalten</translation>
    </message>
    <message>
        <source>End the run under way and keep what is there as a result; those that wait go on</source>
        <translation>Den laufenden Vorgang beenden und behalten, was da ist, als Ergebnis; die wartenden gehen weiter</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>&amp;Cancel run</source>
        <translation>Vorgang &amp;abbrechen</translation>
    </message>
    <message>
        <source>End the run under way and keep nothing of it; those that wait go on</source>
        <translation>Den laufenden Vorgang beenden und nichts davon behalten; die wartenden gehen weiter</translation>
    </message>
    <message>
        <source>E&amp;xtend a picture…</source>
        <translation>Ein Bild er&amp;weitern …</translation>
    </message>
    <message>
        <source>Make more of a picture beyond its edges, with a method that completes pictures</source>
        <translation>Ein Bild über seine Ränder hinaus fortsetzen, mit einem Verfahren, das Bilder ergänzt</translation>
    </message>
    <message>
        <source>Export a&amp;gain</source>
        <translation>Er&amp;neut exportieren</translation>
    </message>
    <message>
        <source>Write the result to the folder and in the way of the last export, without asking</source>
        <translation>Das Ergebnis ohne Rückfrage in den Ordner und auf die Art des letzten Exports schreiben</translation>
    </message>
    <message>
        <source>&amp;Navigator</source>
        <translation>&amp;Navigator</translation>
    </message>
    <message>
        <source>Show the whole picture small where a part of it is shown, or hide it</source>
        <translation>Das ganze Bild klein zeigen, wo ein Teil davon zu sehen ist, oder es verbergen</translation>
    </message>
    <message>
        <source>H&amp;istogram, waveform</source>
        <translation>H&amp;istogramm, Wellenform</translation>
    </message>
    <message>
        <source>Show the histogram of the picture, then its waveform, then neither</source>
        <translation>Das Histogramm des Bildes zeigen, dann seine Wellenform, dann keines von beiden</translation>
    </message>
    <message>
        <source>Stac&amp;k panels</source>
        <translation>Bereiche &amp;stapeln</translation>
    </message>
    <message>
        <source>Put all panels on one another at the right, as on small screens</source>
        <translation>Legt alle Bereiche rechts übereinander, wie auf kleinen Bildschirmen</translation>
    </message>
</context>
<context>
    <name>texloom::ui::AnalogyView</name>
    <message>
        <source>A′</source>
        <translation>A′</translation>
    </message>
    <message>
        <source>Exemplar</source>
        <translation>Vorlage</translation>
    </message>
    <message>
        <source>B′</source>
        <translation>B′</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>&lt;b&gt;A′&lt;/b&gt; The exemplar, which stands to A as the result will stand to B. A click opens another one.</source>
        <translation>&lt;b&gt;A′&lt;/b&gt; Die Vorlage, die zu A steht wie das Ergebnis zu B stehen wird. Ein Klick öffnet eine andere.</translation>
    </message>
    <message>
        <source>A′: open another exemplar</source>
        <translation>A′: eine andere Vorlage öffnen</translation>
    </message>
    <message>
        <source>&lt;b&gt;B′&lt;/b&gt; The result, made from A, A′ and B. A click shows it.</source>
        <translation>&lt;b&gt;B′&lt;/b&gt; Das Ergebnis, aus A, A′ und B gemacht. Ein Klick zeigt es.</translation>
    </message>
    <message>
        <source>B′: show the result</source>
        <translation>B′: das Ergebnis zeigen</translation>
    </message>
    <message>
        <source>Open the result that is shown as an exemplar</source>
        <translation>Das gezeigte Ergebnis als Vorlage öffnen</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>Nichts</translation>
    </message>
    <message>
        <source>Not made yet</source>
        <translation>Noch nicht gemacht</translation>
    </message>
</context>
<context>
    <name>texloom::ui::BlendWindow</name>
    <message>
        <source>Show the cur&amp;ve and its band</source>
        <translation>K&amp;urve und Streifen zeigen</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>Open as e&amp;xemplar</source>
        <translation>Als &amp;Vorlage öffnen</translation>
    </message>
    <message>
        <source>Blend two images</source>
        <translation>Zwei Bilder überblenden</translation>
    </message>
    <message>
        <source>&amp;First</source>
        <translation>&amp;Erstes</translation>
    </message>
    <message>
        <source>S&amp;econd</source>
        <translation>&amp;Zweites</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Öffnen …</translation>
    </message>
    <message>
        <source>Open a file as the first image</source>
        <translation>Eine Datei als erstes Bild öffnen</translation>
    </message>
    <message>
        <source>Open a file as the second image</source>
        <translation>Eine Datei als zweites Bild öffnen</translation>
    </message>
    <message>
        <source>%1…</source>
        <translation>%1 …</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Open an image</source>
        <translation>Bild öffnen</translation>
    </message>
    <message>
        <source>Tick at least one way to show.</source>
        <translation>Haken Sie mindestens eine Art zum Zeigen an.</translation>
    </message>
    <message>
        <source>Blending…</source>
        <translation>Wird überblendet …</translation>
    </message>
    <message>
        <source>%1 and %2.png</source>
        <translation>%1 und %2.png</translation>
    </message>
    <message>
        <source>Save the blend</source>
        <translation>Überblendung speichern</translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.tif *.exr *.hdr)</source>
        <translation>Bilder (*.png *.jpg *.tif *.exr *.hdr)</translation>
    </message>
    <message>
        <source>Wrote %1.</source>
        <translation>%1 geschrieben.</translation>
    </message>
    <message>
        <source>Reading “%1”…</source>
        <translation>„%1“ wird gelesen …</translation>
    </message>
    <message>
        <source>&amp;Tool</source>
        <translation>&amp;Werkzeug</translation>
    </message>
    <message>
        <source>Choose two images.</source>
        <translation>Wählen Sie zwei Bilder.</translation>
    </message>
    <message>
        <source>Stopped. The pictures are those of earlier settings; any change starts again.</source>
        <translation>Angehalten. Die Bilder gehören zu früheren Einstellungen; jede Änderung beginnt neu.</translation>
    </message>
    <message>
        <source>Open two images to blend.</source>
        <translation>Öffnen Sie zwei Bilder, um sie zu überblenden.</translation>
    </message>
    <message>
        <source>Both images are “%1”. Open or choose another one to blend it with.</source>
        <translation>Beide Bilder sind „%1“. Öffnen oder wählen Sie ein anderes, um es damit zu überblenden.</translation>
    </message>
    <message>
        <source>“%1” is %2 px, “%3” is %4 px: both are cropped to %5 px from the top left.</source>
        <translation>„%1“ hat %2 px, „%3“ hat %4 px: beide werden von links oben auf %5 px beschnitten.</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>&amp;Paint the region…</source>
        <translation>Bereich &amp;malen…</translation>
    </message>
    <message>
        <source>Show the re&amp;gion’s outline</source>
        <translation>Umriss des &amp;Bereichs zeigen</translation>
    </message>
</context>
<context>
    <name>texloom::ui::BoxDialog</name>
    <message>
        <source>Box of voxels</source>
        <translation>Quader aus Voxeln</translation>
    </message>
    <message>
        <source>First voxel</source>
        <translation>Erstes Voxel</translation>
    </message>
    <message>
        <source>Voxels</source>
        <translation>Voxel</translation>
    </message>
    <message>
        <source>First voxel along %1</source>
        <translation>Erstes Voxel entlang %1</translation>
    </message>
    <message>
        <source>Voxels along %1</source>
        <translation>Voxel entlang %1</translation>
    </message>
    <message>
        <source>%1 voxels</source>
        <translation>%1 Voxel</translation>
    </message>
</context>
<context>
    <name>texloom::ui::CandidateTable</name>
    <message>
        <source>Lattices to choose from</source>
        <translation>Gitter zur Auswahl</translation>
    </message>
    <message>
        <source>Goodness</source>
        <translation>Güte</translation>
    </message>
    <message>
        <source>free</source>
        <translation>frei</translation>
    </message>
    <message>
        <source>Only rows repeat: what lies along them comes from anywhere in a row</source>
        <translation>Nur Reihen wiederholen sich: Was in ihnen liegt, kommt von irgendwo in einer Reihe</translation>
    </message>
    <message>
        <source>Mean correlation %1 over %2 multiples of the vectors</source>
        <translation>Mittlere Korrelation %1 über %2 Vielfache der Vektoren</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>A small result with this lattice</source>
        <translation>Ein kleines Ergebnis mit diesem Gitter</translation>
    </message>
    <message>
        <source>Vectors</source>
        <translation>Vektoren</translation>
    </message>
</context>
<context>
    <name>texloom::ui::CompanionList</name>
    <message>
        <source>Companion maps</source>
        <translation>Begleitkarten</translation>
    </message>
    <message>
        <source>What the map holds</source>
        <translation>Was die Karte enthält</translation>
    </message>
    <message>
        <source>What the map holds. Normals turn with the exemplar.</source>
        <translation>Was die Karte enthält. Normalen drehen sich mit der Vorlage.</translation>
    </message>
    <message>
        <source>Add…</source>
        <translation>Hinzufügen …</translation>
    </message>
    <message>
        <source>Add companion maps</source>
        <translation>Begleitkarten hinzufügen</translation>
    </message>
    <message>
        <source>Add maps of the exemplar&apos;s size, such as normals or heights: they get the result&apos;s layout.</source>
        <translation>Karten von der Größe der Vorlage hinzufügen, etwa Normalen oder Höhen: Sie bekommen die Anordnung des Ergebnisses.</translation>
    </message>
    <message>
        <source>Remove the map</source>
        <translation>Die Karte entfernen</translation>
    </message>
    <message>
        <source>None yet</source>
        <translation>Noch keine</translation>
    </message>
    <message>
        <source>Drop maps such as bark_normal and bark_rough with bark, or add them.</source>
        <translation>Ziehen Sie Karten wie bark_normal und bark_rough mit bark herein, oder fügen Sie sie hinzu.</translation>
    </message>
    <message>
        <source>red</source>
        <translation>Rot</translation>
    </message>
    <message>
        <source>green</source>
        <translation>Grün</translation>
    </message>
    <message>
        <source>blue</source>
        <translation>Blau</translation>
    </message>
    <message>
        <source>alpha</source>
        <translation>Alpha</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>channel %1</source>
        <translation>Kanal %1</translation>
    </message>
    <message>
        <source>%1, inverted</source>
        <translation>%1, umgekehrt</translation>
    </message>
    <message>
        <source>%1, derived</source>
        <translation>%1, abgeleitet</translation>
    </message>
    <message>
        <source>%1, layer %2</source>
        <translation>%1, Ebene %2</translation>
    </message>
</context>
<context>
    <name>texloom::ui::CompareActions</name>
    <message>
        <source>&amp;Grid</source>
        <translation>&amp;Raster</translation>
    </message>
    <message>
        <source>Compare pictures side by side</source>
        <translation>Bilder nebeneinander vergleichen</translation>
    </message>
    <message>
        <source>&amp;Wipe</source>
        <translation>&amp;Wischen</translation>
    </message>
    <message>
        <source>Compare two pictures in one place, parted by a line</source>
        <translation>Zwei Bilder an einer Stelle vergleichen, durch eine Linie geteilt</translation>
    </message>
    <message>
        <source>&amp;Toggle</source>
        <translation>&amp;Umschalten</translation>
    </message>
    <message>
        <source>Compare two pictures in one place, one after the other</source>
        <translation>Zwei Bilder an einer Stelle vergleichen, eines nach dem anderen</translation>
    </message>
    <message>
        <source>&amp;Difference</source>
        <translation>&amp;Differenz</translation>
    </message>
    <message>
        <source>Show what two pictures differ in</source>
        <translation>Zeigen, worin sich zwei Bilder unterscheiden</translation>
    </message>
    <message>
        <source>E&amp;xemplar</source>
        <translation>&amp;Vorlage</translation>
    </message>
    <message>
        <source>&amp;Link views</source>
        <translation>Ansichten &amp;koppeln</translation>
    </message>
    <message>
        <source>Zoom and move all pictures together; those moved apart before stay apart as they are</source>
        <translation>Alle Bilder gemeinsam zoomen und bewegen; vorher verschobene bleiben so verschoben</translation>
    </message>
    <message>
        <source>&amp;Contact sheet…</source>
        <translation>K&amp;ontaktbogen …</translation>
    </message>
    <message>
        <source>Write all pictures with their labels into one PNG file</source>
        <translation>Alle Bilder mit ihren Beschriftungen in eine PNG-Datei schreiben</translation>
    </message>
    <message>
        <source>Show the exemplars of the results beside them</source>
        <translation>Die Vorlagen der Ergebnisse neben ihnen zeigen</translation>
    </message>
    <message>
        <source>Open e&amp;xemplars</source>
        <translation>Geöffnete Vor&amp;lagen</translation>
    </message>
    <message>
        <source>With its &amp;input</source>
        <translation>Mit seiner E&amp;ingabe</translation>
    </message>
    <message>
        <source>Compare the result that is shown with the image that it was made from</source>
        <translation>Das gezeigte Ergebnis mit dem Bild vergleichen, aus dem es gemacht wurde</translation>
    </message>
</context>
<context>
    <name>texloom::ui::CompareBar</name>
    <message>
        <source>First picture</source>
        <translation>Erstes Bild</translation>
    </message>
    <message>
        <source>Second picture</source>
        <translation>Zweites Bild</translation>
    </message>
    <message>
        <source>Kind of difference</source>
        <translation>Art der Differenz</translation>
    </message>
    <message>
        <source>Absolute</source>
        <translation>Absolut</translation>
    </message>
    <message>
        <source>Squared</source>
        <translation>Quadriert</translation>
    </message>
    <message>
        <source>Relative</source>
        <translation>Relativ</translation>
    </message>
    <message>
        <source> EV</source>
        <translation> EV</translation>
    </message>
    <message>
        <source>Exposure in stops</source>
        <translation>Belichtung in Blendenstufen</translation>
    </message>
    <message>
        <source>Brightens or darkens all pictures on the screen; each stop doubles the light</source>
        <translation>Hellt alle Bilder am Schirm auf oder dunkelt sie ab; jede Stufe verdoppelt das Licht</translation>
    </message>
    <message>
        <source>Channel shown</source>
        <translation>Gezeigter Kanal</translation>
    </message>
    <message>
        <source>The channel shown of all pictures (Shift+C, R, G, B, A)</source>
        <translation>Der gezeigte Kanal aller Bilder (Umschalt+C, R, G, B, A)</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Red</source>
        <translation>Rot</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>Grün</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>Blau</translation>
    </message>
    <message>
        <source>Alpha</source>
        <translation>Alpha</translation>
    </message>
</context>
<context>
    <name>texloom::ui::CompareCell</name>
    <message>
        <source>Bring the settings of this result into the form (Return); Run then makes it in full size</source>
        <translation>Die Einstellungen dieses Ergebnisses ins Formular übernehmen (Eingabe); Ausführen erzeugt es dann in voller Größe</translation>
    </message>
    <message>
        <source>Restore settings</source>
        <translation>Einstellungen wiederherstellen</translation>
    </message>
    <message>
        <source>Restore the settings of %1</source>
        <translation>Einstellungen von %1 wiederherstellen</translation>
    </message>
</context>
<context>
    <name>texloom::ui::CompareView</name>
    <message>
        <source>RMSE %1</source>
        <translation>RMSE %1</translation>
    </message>
    <message>
        <source>mean relative difference %1</source>
        <translation>mittlere relative Differenz %1</translation>
    </message>
    <message>
        <source>mean absolute difference %1</source>
        <translation>mittlere absolute Differenz %1</translation>
    </message>
    <message>
        <source>%1 over the %2 px that both have</source>
        <translation>%1 über die %2 px, die beide haben</translation>
    </message>
    <message>
        <source>Comparison</source>
        <translation>Vergleich</translation>
    </message>
    <message>
        <source>Two pictures are needed; choose them above.</source>
        <translation>Zwei Bilder werden gebraucht; wählen Sie sie oben.</translation>
    </message>
    <message>
        <source>Choose results in the Results dock and press Compare, or Try all methods in the Synthesis menu.</source>
        <translation>Wählen Sie Ergebnisse im Bereich „Ergebnisse“ und drücken Sie „Vergleichen“, oder probieren Sie im Menü „Synthese“ alle Verfahren.</translation>
    </message>
</context>
<context>
    <name>texloom::ui::Comparisons</name>
    <message>
        <source>&amp;Compare</source>
        <translation>&amp;Vergleichen</translation>
    </message>
    <message>
        <source>This result was removed.</source>
        <translation>Dieses Ergebnis wurde entfernt.</translation>
    </message>
    <message>
        <source>%1 · exemplar · %2</source>
        <translation>%1 · Vorlage · %2</translation>
    </message>
    <message>
        <source>No exemplar is open</source>
        <translation>Keine Vorlage ist geöffnet</translation>
    </message>
    <message>
        <source>Write a contact sheet</source>
        <translation>Kontaktbogen schreiben</translation>
    </message>
    <message>
        <source>PNG pictures (*.png)</source>
        <translation>PNG-Bilder (*.png)</translation>
    </message>
    <message>
        <source>Wrote %1.</source>
        <translation>%1 geschrieben.</translation>
    </message>
    <message>
        <source>There is no result yet that could be compared; press Run first.</source>
        <translation>Es gibt noch kein Ergebnis, das verglichen werden könnte; starten Sie zuerst einen Lauf.</translation>
    </message>
    <message>
        <source>This result was not made from an image beside the exemplar; show one that completes or changes an image.</source>
        <translation>Dieses Ergebnis wurde nicht aus einem Bild neben der Vorlage gemacht; zeigen Sie eines, das ein Bild ergänzt oder verändert.</translation>
    </message>
</context>
<context>
    <name>texloom::ui::DifferenceDialog</name>
    <message>
        <source>Differences in settings</source>
        <translation>Unterschiede der Einstellungen</translation>
    </message>
    <message>
        <source>Setting</source>
        <translation>Einstellung</translation>
    </message>
    <message>
        <source>Both were made with the same settings, so they are the same.</source>
        <translation>Beide entstanden mit denselben Einstellungen und sind daher gleich.</translation>
    </message>
</context>
<context>
    <name>texloom::ui::Document</name>
    <message>
        <source>Sessions (*.texloom)</source>
        <translation>Sitzungen (*.texloom)</translation>
    </message>
    <message>
        <source>&amp;New session</source>
        <translation>&amp;Neue Sitzung</translation>
    </message>
    <message>
        <source>Open &amp;session…</source>
        <translation>&amp;Sitzung öffnen …</translation>
    </message>
    <message>
        <source>Recent sess&amp;ions</source>
        <translation>&amp;Zuletzt benutzte Sitzungen</translation>
    </message>
    <message>
        <source>S&amp;ave session</source>
        <translation>Sitzung s&amp;peichern</translation>
    </message>
    <message>
        <source>Save session &amp;as…</source>
        <translation>Sitzung speichern &amp;unter …</translation>
    </message>
    <message>
        <source>Save session &amp;with its images…</source>
        <translation>Sitzung &amp;mit ihren Bildern speichern …</translation>
    </message>
    <message>
        <source>No session saved yet</source>
        <translation>Noch keine Sitzung gespeichert</translation>
    </message>
    <message>
        <source>Open session</source>
        <translation>Sitzung öffnen</translation>
    </message>
    <message>
        <source>Opened, but without some files: %1</source>
        <translation>Geöffnet, aber ohne einige Dateien: %1</translation>
    </message>
    <message>
        <source>Save session</source>
        <translation>Sitzung speichern</translation>
    </message>
    <message>
        <source>Save session with its images</source>
        <translation>Sitzung mit ihren Bildern speichern</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1 gespeichert.</translation>
    </message>
    <message>
        <source>The session was not saved. %1</source>
        <translation>Die Sitzung wurde nicht gespeichert. %1</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Ungespeicherte Änderungen</translation>
    </message>
    <message>
        <source>%1 has changes that are not saved.</source>
        <translation>%1 hat Änderungen, die nicht gespeichert sind.</translation>
    </message>
    <message>
        <source>The exemplars were edited, and no session holds that yet. Results are kept in any case.</source>
        <translation>Die Vorlagen wurden bearbeitet, und noch keine Sitzung enthält das. Ergebnisse bleiben auf jeden Fall.</translation>
    </message>
    <message>
        <source>Opened, but these files changed since the session was saved, so results will differ: %1.</source>
        <translation>Geöffnet, aber diese Dateien haben sich seit dem Speichern geändert, sodass Ergebnisse anders ausfallen: %1.</translation>
    </message>
    <message>
        <source>the session</source>
        <translation>die Sitzung</translation>
    </message>
</context>
<context>
    <name>texloom::ui::DropTargets</name>
    <message>
        <source>Places to drop</source>
        <translation>Ablageorte</translation>
    </message>
    <message>
        <source>Exemplar</source>
        <translation>Vorlage</translation>
    </message>
    <message>
        <source>In place of the one you look at</source>
        <translation>Anstelle der gezeigten</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Companion map</source>
        <translation>Begleitkarte</translation>
    </message>
    <message>
        <source>Gets the result&apos;s layout</source>
        <translation>Bekommt die Anordnung des Ergebnisses</translation>
    </message>
    <message>
        <source>Mask</source>
        <translation>Maske</translation>
    </message>
    <message>
        <source>Black is never copied</source>
        <translation>Schwarzes wird nie kopiert</translation>
    </message>
    <message>
        <source>The method does not use a mask</source>
        <translation>Das Verfahren benutzt keine Maske</translation>
    </message>
    <message>
        <source>Mixed with the exemplars in use</source>
        <translation>Gemischt mit den verwendeten Vorlagen</translation>
    </message>
    <message>
        <source>Opened to learn from</source>
        <translation>Zum Lernen geöffnet</translation>
    </message>
</context>
<context>
    <name>texloom::ui::ExampleSessions</name>
    <message>
        <source>Exa&amp;mple sessions</source>
        <translation>Beispielsitzun&amp;gen</translation>
    </message>
    <message>
        <source>None were found beside the program</source>
        <translation>Neben dem Programm wurden keine gefunden</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>texloom::ui::ExampleSweeps</name>
    <message>
        <source>Exa&amp;mple sweeps</source>
        <translation>&amp;Beispielreihen</translation>
    </message>
    <message>
        <source>None were found beside the program</source>
        <translation>Neben dem Programm wurden keine gefunden</translation>
    </message>
</context>
<context>
    <name>texloom::ui::ExemplarEditor</name>
    <message>
        <source>Exemplar being edited</source>
        <translation>Vorlage in Bearbeitung</translation>
    </message>
    <message>
        <source>&amp;Done</source>
        <translation>&amp;Fertig</translation>
    </message>
    <message>
        <source>&amp;Look</source>
        <translation>Betr&amp;achten</translation>
    </message>
    <message>
        <source>Zoom and pan</source>
        <translation>Zoomen und verschieben</translation>
    </message>
    <message>
        <source>&amp;Hide</source>
        <translation>Ver&amp;bergen</translation>
    </message>
    <message>
        <source>Paint over what is never copied</source>
        <translation>Übermalen, was nie kopiert wird</translation>
    </message>
    <message>
        <source>&amp;Unhide</source>
        <translation>&amp;Zeigen</translation>
    </message>
    <message>
        <source>Paint over what may be copied again</source>
        <translation>Übermalen, was wieder kopiert werden darf</translation>
    </message>
    <message>
        <source>The wheel zooms, dragging moves. Choose a tool above, or turn, mirror and even out the light below. Files stay as they are.</source>
        <translation>Das Rad zoomt, Ziehen verschiebt. Wählen Sie oben ein Werkzeug, oder drehen, spiegeln und Licht ausgleichen Sie unten. Dateien bleiben, wie sie sind.</translation>
    </message>
    <message>
        <source>Hatched = never copied. Shift and the arrow keys move the brush, the space bar dabs.</source>
        <translation>Schraffiert = nie kopiert. Umschalt und Pfeiltasten bewegen den Pinsel, die Leertaste tupft.</translation>
    </message>
    <message>
        <source>The method in use does not use a mask.</source>
        <translation>Das gewählte Verfahren benutzt keine Maske.</translation>
    </message>
    <message>
        <source>Clear &amp;mask</source>
        <translation>&amp;Maske löschen</translation>
    </message>
    <message>
        <source>Edits, in order</source>
        <translation>Bearbeitungen, der Reihe nach</translation>
    </message>
    <message>
        <source>&amp;Take back</source>
        <translation>Zu&amp;rücknehmen</translation>
    </message>
    <message>
        <source>Takes the chosen edit out; those after it stay where they fit.</source>
        <translation>Nimmt die gewählte Bearbeitung heraus; die danach bleiben, wo sie passen.</translation>
    </message>
    <message>
        <source>%1 · %2 px</source>
        <translation>%1 · %2 px</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Vorher</translation>
    </message>
    <message>
        <source>Take back an edit</source>
        <translation>Bearbeitung zurücknehmen</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Vorschau</translation>
    </message>
    <message>
        <source>%1 (being made)</source>
        <translation>%1 (in Arbeit)</translation>
    </message>
</context>
<context>
    <name>texloom::ui::ExemplarPanel</name>
    <message>
        <source>grey</source>
        <translation>grau</translation>
    </message>
    <message>
        <source>colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>colour and alpha</source>
        <translation>Farbe und Alpha</translation>
    </message>
    <message>
        <source>%1 channels</source>
        <translation>%1 Kanäle</translation>
    </message>
    <message>
        <source>%1 px · %2 · %3 · %4</source>
        <translation>%1 px · %2 · %3 · %4</translation>
    </message>
    <message>
        <source>Exemplar</source>
        <translation>Vorlage</translation>
    </message>
    <message>
        <source>No exemplar yet.
Drop a picture here.</source>
        <translation>Noch keine Vorlage.
Ziehen Sie ein Bild hierher.</translation>
    </message>
    <message>
        <source>Open exemplars</source>
        <translation>Vorlagen öffnen</translation>
    </message>
    <message>
        <source>The colour space that the file&apos;s values are in. Data, such as heights, is never converted.</source>
        <translation>Der Farbraum, in dem die Werte der Datei sind. Daten wie Höhen werden nie umgerechnet.</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wählen …</translation>
    </message>
    <message>
        <source>A picture of the exemplar&apos;s size: where it is black, nothing is copied.</source>
        <translation>Ein Bild von der Größe der Vorlage: Wo es schwarz ist, wird nichts kopiert.</translation>
    </message>
    <message>
        <source>Choose a mask</source>
        <translation>Maske wählen</translation>
    </message>
    <message>
        <source>Remove the mask</source>
        <translation>Die Maske entfernen</translation>
    </message>
    <message>
        <source>&amp;Colour space</source>
        <translation>&amp;Farbraum</translation>
    </message>
    <message>
        <source>Mask</source>
        <translation>Maske</translation>
    </message>
    <message>
        <source>Maps</source>
        <translation>Karten</translation>
    </message>
    <message>
        <source>The method does not use a mask.</source>
        <translation>Das Verfahren benutzt keine Maske.</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Position map</source>
        <translation>Positionskarte</translation>
    </message>
    <message>
        <source>Wei&amp;ght</source>
        <translation>&amp;Gewicht</translation>
    </message>
    <message>
        <source>%1 (× %2)</source>
        <translation>%1 (× %2)</translation>
    </message>
    <message>
        <source>Painted</source>
        <translation>Gemalt</translation>
    </message>
    <message>
        <source>How much the exemplar counts beside the others: with 2 as though it were open twice.</source>
        <translation>Wie viel die Vorlage neben den anderen zählt: mit 2, als wäre sie zweimal geöffnet.</translation>
    </message>
    <message>
        <source>The method takes all exemplars alike.</source>
        <translation>Das Verfahren nimmt alle Vorlagen gleich.</translation>
    </message>
    <message>
        <source>The method learns from one exemplar, the one that is chosen.</source>
        <translation>Das Verfahren lernt von einer Vorlage, der gewählten.</translation>
    </message>
    <message>
        <source>The file holds several pictures; this is the one that is learnt from.</source>
        <translation>Die Datei enthält mehrere Bilder; aus diesem wird gelernt.</translation>
    </message>
    <message>
        <source>&amp;Layer</source>
        <translation>&amp;Ebene</translation>
    </message>
</context>
<context>
    <name>texloom::ui::ExemplarStore</name>
    <message>
        <source>Colour space</source>
        <translation>Farbraum</translation>
    </message>
    <message>
        <source>Mask</source>
        <translation>Maske</translation>
    </message>
    <message>
        <source>Clear mask</source>
        <translation>Maske löschen</translation>
    </message>
    <message>
        <source>Paint mask</source>
        <translation>Maske malen</translation>
    </message>
    <message>
        <source>Erase mask</source>
        <translation>Maske radieren</translation>
    </message>
    <message>
        <source>Add companion map</source>
        <translation>Begleitkarte hinzufügen</translation>
    </message>
    <message>
        <source>Remove companion map</source>
        <translation>Begleitkarte entfernen</translation>
    </message>
    <message>
        <source>Kind of companion map</source>
        <translation>Art der Begleitkarte</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Gewicht</translation>
    </message>
    <message>
        <source>Use exemplar</source>
        <translation>Vorlage verwenden</translation>
    </message>
    <message>
        <source>Leave exemplar out</source>
        <translation>Vorlage weglassen</translation>
    </message>
    <message>
        <source>exemplars</source>
        <translation>Vorlagen</translation>
    </message>
    <message>
        <source>Layer</source>
        <translation>Ebene</translation>
    </message>
</context>
<context>
    <name>texloom::ui::ExportDialog</name>
    <message>
        <source>S&amp;TMap for compositors (EXR)</source>
        <translation>S&amp;TMap für Compositing (EXR)</translation>
    </message>
    <message>
        <source>Exact &amp;positions (16-bit PNG)</source>
        <translation>Genaue &amp;Positionen (16-Bit-PNG)</translation>
    </message>
    <message>
        <source>&amp;Recipe beside the picture (JSON)</source>
        <translation>&amp;Rezept neben dem Bild (JSON)</translation>
    </message>
    <message>
        <source>Companion &amp;maps</source>
        <translation>Begleit&amp;karten</translation>
    </message>
    <message>
        <source>What the files are called, which maps share one, and where green points in normal maps.</source>
        <translation>Wie die Dateien heißen, welche Karten sich eine teilen und wohin Grün in Normalenkarten zeigt.</translation>
    </message>
    <message>
        <source>The name of the files. $name is the exemplar&apos;s, $map the kind of map; there is $method, $seed, $w, $h, $size and $place, too.</source>
        <translation>Der Name der Dateien. $name ist der der Vorlage, $map die Art der Karte; es gibt auch $method, $seed, $w, $h, $size und $place.</translation>
    </message>
    <message>
        <source>As the preset says</source>
        <translation>Wie die Vorgabe sagt</translation>
    </message>
    <message>
        <source>OpenGL, green up</source>
        <translation>OpenGL, Grün nach oben</translation>
    </message>
    <message>
        <source>DirectX, green down</source>
        <translation>DirectX, Grün nach unten</translation>
    </message>
    <message>
        <source>PNG</source>
        <translation>PNG</translation>
    </message>
    <message>
        <source>TIFF</source>
        <translation>TIFF</translation>
    </message>
    <message>
        <source>OpenEXR</source>
        <translation>OpenEXR</translation>
    </message>
    <message>
        <source>JPEG</source>
        <translation>JPEG</translation>
    </message>
    <message>
        <source>Radiance HDR</source>
        <translation>Radiance HDR</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>Automatic: sRGB, or linear for depths that hold it.</source>
        <translation>Automatisch: sRGB oder linear bei Tiefen, die es fassen.</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wählen …</translation>
    </message>
    <message>
        <source>Choose a folder</source>
        <translation>Ordner wählen</translation>
    </message>
    <message>
        <source>This method makes new pixels, so there is no map of where they came from.</source>
        <translation>Dieses Verfahren erzeugt neue Pixel, also gibt es keine Karte ihrer Herkunft.</translation>
    </message>
    <message>
        <source>All settings, to make the same result again.</source>
        <translation>Alle Einstellungen, um dasselbe Ergebnis wieder zu erzeugen.</translation>
    </message>
    <message>
        <source>&amp;Folder</source>
        <translation>&amp;Ordner</translation>
    </message>
    <message>
        <source>&amp;Preset</source>
        <translation>&amp;Vorgabe</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Name</translation>
    </message>
    <message>
        <source>F&amp;ormat</source>
        <translation>Forma&amp;t</translation>
    </message>
    <message>
        <source>&amp;Depth</source>
        <translation>T&amp;iefe</translation>
    </message>
    <message>
        <source>&amp;Colour space</source>
        <translation>&amp;Farbraum</translation>
    </message>
    <message>
        <source>Norm&amp;als</source>
        <translation>Norma&amp;len</translation>
    </message>
    <message>
        <source>Position map</source>
        <translation>Positionskarte</translation>
    </message>
    <message>
        <source>Also</source>
        <translation>Außerdem</translation>
    </message>
    <message>
        <source>&amp;Write files</source>
        <translation>Dateien s&amp;chreiben</translation>
    </message>
    <message>
        <source>The files need a name.</source>
        <translation>Die Dateien brauchen einen Namen.</translation>
    </message>
    <message>
        <source>The name cannot hold a slash; choose the folder above.</source>
        <translation>Der Name kann keinen Schrägstrich enthalten; wählen Sie den Ordner oben.</translation>
    </message>
    <message>
        <source>Choose the folder to write to.</source>
        <translation>Wählen Sie den Ordner, in den geschrieben wird.</translation>
    </message>
    <message>
        <source>The folder %1 is not there.</source>
        <translation>Den Ordner %1 gibt es nicht.</translation>
    </message>
    <message>
        <source>→ %1</source>
        <translation>→ %1</translation>
    </message>
    <message>
        <source>Export to</source>
        <translation>Exportieren nach</translation>
    </message>
    <message>
        <source>Folder to write to</source>
        <translation>Ordner zum Schreiben</translation>
    </message>
    <message>
        <source>Export “%1”</source>
        <translation>„%1“ exportieren</translation>
    </message>
    <message>
        <source>Replace &amp;files that Texloom did not write</source>
        <translation>&amp;Dateien ersetzen, die nicht von Texloom sind</translation>
    </message>
    <message>
        <source>Written as</source>
        <translation>Geschrieben als</translation>
    </message>
    <message>
        <source>Raw numbers with JSON</source>
        <translation>Rohe Zahlen mit JSON</translation>
    </message>
    <message>
        <source>Slices as PNG</source>
        <translation>Schnitte als PNG</translation>
    </message>
    <message>
        <source>Slices as TIFF</source>
        <translation>Schnitte als TIFF</translation>
    </message>
    <message>
        <source>Slices as OpenEXR</source>
        <translation>Schnitte als OpenEXR</translation>
    </message>
    <message>
        <source>%1 voxels are written.</source>
        <translation>%1 Voxel werden geschrieben.</translation>
    </message>
    <message>
        <source>%1 is there, and Texloom did not write it. Choose another name or folder, or allow that it is replaced.</source>
        <translation>%1 ist schon da und nicht von Texloom. Wählen Sie einen anderen Namen oder Ordner, oder erlauben Sie, dass es ersetzt wird.</translation>
    </message>
    <message>
        <source>Create &amp;folder</source>
        <translation>&amp;Ordner anlegen</translation>
    </message>
    <message>
        <source>The folder %1 cannot be made.</source>
        <translation>Der Ordner %1 kann nicht angelegt werden.</translation>
    </message>
    <message>
        <source>%1, %2 values clipped</source>
        <translation>%1, %2 Werte abgeschnitten</translation>
    </message>
    <message>
        <source>Edit…</source>
        <translation>Bearbeiten …</translation>
    </message>
    <message>
        <source>Make and change presets of your own</source>
        <translation>Eigene Vorgaben anlegen und ändern</translation>
    </message>
    <message>
        <source>Edit export presets</source>
        <translation>Export-Vorgaben bearbeiten</translation>
    </message>
</context>
<context>
    <name>texloom::ui::ExportTable</name>
    <message>
        <source>8-bit</source>
        <translation>8 Bit</translation>
    </message>
    <message>
        <source>16-bit</source>
        <translation>16 Bit</translation>
    </message>
    <message>
        <source>half</source>
        <translation>halbe Genauigkeit</translation>
    </message>
    <message>
        <source>float</source>
        <translation>Gleitkomma</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Holds</source>
        <translation>Enthält</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>On disk</source>
        <translation>Auf dem Datenträger</translation>
    </message>
    <message>
        <source>Files that will be written</source>
        <translation>Dateien, die geschrieben werden</translation>
    </message>
    <message>
        <source>replaces a file that is not Texloom&apos;s</source>
        <translation>ersetzt eine Datei, die nicht von Texloom ist</translation>
    </message>
    <message>
        <source>replaces the file there</source>
        <translation>ersetzt die Datei dort</translation>
    </message>
    <message>
        <source>new</source>
        <translation>neu</translation>
    </message>
    <message>
        <source>Depth of %1</source>
        <translation>Tiefe von %1</translation>
    </message>
</context>
<context>
    <name>texloom::ui::ExtendDialog</name>
    <message>
        <source>Extend the picture</source>
        <translation>Das Bild erweitern</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>&amp;Links</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>&amp;Oben</translation>
    </message>
    <message>
        <source>&amp;Right</source>
        <translation>&amp;Rechts</translation>
    </message>
    <message>
        <source>&amp;Bottom</source>
        <translation>&amp;Unten</translation>
    </message>
    <message>
        <source>How far the picture is to reach beyond each of its edges. What lies there is made by the next run.</source>
        <translation>Wie weit das Bild über jeden seiner Ränder reichen soll. Was dort liegt, macht der nächste Lauf.</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>%1 → %2 px</source>
        <translation>%1 → %2 px</translation>
    </message>
    <message>
        <source>%1 px is too large; its sides go up to %2.</source>
        <translation>%1 px ist zu groß; die Seiten gehen bis %2.</translation>
    </message>
</context>
<context>
    <name>texloom::ui::FiguresPanel</name>
    <message>
        <source>exemplar</source>
        <translation>Vorlage</translation>
    </message>
    <message>
        <source>result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>difference</source>
        <translation>Differenz</translation>
    </message>
    <message>
        <source>%1: %2 % in other bins</source>
        <translation>%1: %2 % in anderen Klassen</translation>
    </message>
    <message>
        <source>share, %</source>
        <translation>Anteil, %</translation>
    </message>
    <message>
        <source>Figures</source>
        <translation>Kennzahlen</translation>
    </message>
    <message>
        <source>Make a result to see its figures.</source>
        <translation>Erzeugen Sie ein Ergebnis, um seine Kennzahlen zu sehen.</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>Zahlen</translation>
    </message>
    <message>
        <source>Figure</source>
        <translation>Kennzahl</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Looking at the result…</source>
        <translation>Ergebnis wird betrachtet …</translation>
    </message>
    <message>
        <source>step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>Colours: %1</source>
        <translation>Farben: %1</translation>
    </message>
    <message>
        <source>value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Patches: first component</source>
        <translation>Patches: erste Komponente</translation>
    </message>
    <message>
        <source>Patches: second component</source>
        <translation>Patches: zweite Komponente</translation>
    </message>
    <message>
        <source>place along the principal axis</source>
        <translation>Lage auf der Hauptachse</translation>
    </message>
    <message>
        <source>Autocorrelation: exemplar</source>
        <translation>Autokorrelation: Vorlage</translation>
    </message>
    <message>
        <source>Autocorrelation: result</source>
        <translation>Autokorrelation: Ergebnis</translation>
    </message>
    <message>
        <source>How often pixels are used</source>
        <translation>Wie oft Pixel benutzt werden</translation>
    </message>
    <message>
        <source>How often pixels are used: %1</source>
        <translation>Wie oft Pixel benutzt werden: %1</translation>
    </message>
    <message>
        <source>Stopped. Make another result, or close and open this dock to start again.</source>
        <translation>Angehalten. Erzeugen Sie ein anderes Ergebnis, oder schließen und öffnen Sie diesen Bereich, um neu zu beginnen.</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Arrays</source>
        <translation>Felder</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation>Ecken</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Dreiecke</translation>
    </message>
</context>
<context>
    <name>texloom::ui::FramePage</name>
    <message>
        <source>R&amp;atio</source>
        <translation>Verhä&amp;ltnis</translation>
    </message>
    <message>
        <source>Draw a rectangle, drag its edges or drag it as a whole; Shift makes a square. N takes the next corner, the arrow keys move it. Enter applies, Esc leaves.</source>
        <translation>Ziehen Sie ein Rechteck auf, ziehen Sie seine Kanten oder es als Ganzes; Umschalt macht ein Quadrat. N nimmt die nächste Ecke, die Pfeiltasten bewegen sie. Eingabe wendet an, Esc verlässt.</translation>
    </message>
    <message>
        <source>Drag the corners; N takes the next one, the arrow keys move it. Enter applies, Esc leaves.</source>
        <translation>Ziehen Sie die Ecken; N nimmt die nächste, die Pfeiltasten bewegen sie. Eingabe wendet an, Esc verlässt.</translation>
    </message>
    <message>
        <source>The rectangle&apos;s width by its height</source>
        <translation>Die Breite des Rechtecks durch seine Höhe</translation>
    </message>
    <message>
        <source>Any</source>
        <translation>Beliebig</translation>
    </message>
    <message>
        <source>Square</source>
        <translation>Quadrat</translation>
    </message>
    <message>
        <source>As the picture</source>
        <translation>Wie das Bild</translation>
    </message>
</context>
<context>
    <name>texloom::ui::GridRun</name>
    <message>
        <source>Under way…</source>
        <translation>Läuft …</translation>
    </message>
    <message>
        <source>Waiting…</source>
        <translation>Wartet …</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Abgebrochen.</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>Would take about %1: choose the method and run it by itself.</source>
        <translation>Würde etwa %1 dauern: das Verfahren wählen und für sich ausführen.</translation>
    </message>
</context>
<context>
    <name>texloom::ui::Hovers</name>
    <message>
        <source>%1: x %2, y %3</source>
        <translation>%1: x %2, y %3</translation>
    </message>
    <message>
        <source>working space · float</source>
        <translation>Arbeitsraum · Gleitkomma</translation>
    </message>
    <message>
        <source>x %1, y %2</source>
        <translation>x %1, y %2</translation>
    </message>
    <message>
        <source>%1 → %2 x %3, y %4</source>
        <translation>%1 → %2 x %3, y %4</translation>
    </message>
    <message>
        <source>%1 x %2, y %3</source>
        <translation>%1 x %2, y %3</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>once in the result</source>
        <translation>einmal im Ergebnis</translation>
    </message>
    <message>
        <source>%1 times in the result</source>
        <translation>%1-mal im Ergebnis</translation>
    </message>
</context>
<context>
    <name>texloom::ui::ImageViewer</name>
    <message>
        <source>%1 pixels at %2. %3</source>
        <translation>%1 Pixel bei %2. %3</translation>
    </message>
</context>
<context>
    <name>texloom::ui::Inspector</name>
    <message>
        <source>fexsvhidtc</source>
        <translation>dbvsahgtfk</translation>
    </message>
</context>
<context>
    <name>texloom::ui::JobPanel</name>
    <message>
        <source>%1, %2 left</source>
        <translation>%1, noch %2</translation>
    </message>
    <message>
        <source>about %1</source>
        <translation>etwa %1</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>Failed: %1</source>
        <translation>Fehlgeschlagen: %1</translation>
    </message>
    <message>
        <source>waiting</source>
        <translation>wartet</translation>
    </message>
    <message>
        <source>%1 (preview)</source>
        <translation>%1 (Vorschau)</translation>
    </message>
    <message>
        <source>Move &amp;up</source>
        <translation>Nach &amp;oben</translation>
    </message>
    <message>
        <source>Move &amp;down</source>
        <translation>Nach &amp;unten</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Abbrechen</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>&amp;Pause</translation>
    </message>
    <message>
        <source>C&amp;lear</source>
        <translation>&amp;Leeren</translation>
    </message>
    <message>
        <source>Runs that wait or are under way</source>
        <translation>Vorgänge, die warten oder laufen</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Vorgang</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>At &amp;most</source>
        <translation>&amp;Höchstens</translation>
    </message>
    <message>
        <source>Most threads that runs may use</source>
        <translation>Höchstzahl der Threads für Vorgänge</translation>
    </message>
    <message>
        <source>all threads</source>
        <translation>alle Threads</translation>
    </message>
    <message>
        <source> threads</source>
        <translation> Threads</translation>
    </message>
    <message>
        <source>How many of the processor&apos;s threads runs may use from now on. Fewer leave the computer free for other work; the results are the same.</source>
        <translation>Wie viele Threads des Prozessors Vorgänge von jetzt an benutzen dürfen. Weniger lassen den Rechner für anderes frei; die Ergebnisse sind dieselben.</translation>
    </message>
    <message>
        <source>Move the chosen run forward in the queue</source>
        <translation>Den gewählten Vorgang früher ausführen</translation>
    </message>
    <message>
        <source>Move the chosen run back in the queue</source>
        <translation>Den gewählten Vorgang später ausführen</translation>
    </message>
    <message>
        <source>&amp;Stop and keep</source>
        <translation>An&amp;halten und behalten</translation>
    </message>
    <message>
        <source>End the run under way and keep what is there as a result</source>
        <translation>Den laufenden Vorgang beenden und behalten, was da ist, als Ergebnis</translation>
    </message>
    <message>
        <source>Take the chosen run off the queue; of one under way, nothing is kept</source>
        <translation>Den gewählten Vorgang aus der Warteschlange nehmen; von einem laufenden bleibt nichts</translation>
    </message>
    <message>
        <source>Start none of the waiting runs; the one under way goes on, and Run still works</source>
        <translation>Keinen wartenden Vorgang beginnen; der laufende geht weiter, und „Ausführen“ wirkt noch</translation>
    </message>
    <message>
        <source>Take all waiting and failed runs off the queue</source>
        <translation>Alles Wartende und Fehlgeschlagene aus der Warteschlange nehmen</translation>
    </message>
    <message>
        <source>Double click or Return on the run under way shows its pictures as they are made</source>
        <translation>Doppelklick oder Eingabe auf dem laufenden Vorgang zeigt ihn, wie er wächst</translation>
    </message>
    <message>
        <source>No run is waiting. “Add to queue” puts one here, to be made after those before it.</source>
        <translation>Nichts wartet. „In die Warteschlange“ stellt einen Vorgang hierher.</translation>
    </message>
</context>
<context>
    <name>texloom::ui::LabelPainter</name>
    <message>
        <source>&amp;Fill</source>
        <translation>&amp;Füllen</translation>
    </message>
    <message>
        <source>Fills the area of one colour that is clicked</source>
        <translation>Füllt die Fläche einer Farbe, die angeklickt wird</translation>
    </message>
    <message>
        <source>P&amp;ick colour</source>
        <translation>Farbe aufneh&amp;men</translation>
    </message>
    <message>
        <source>Takes the colour that is clicked, and goes back to the brush</source>
        <translation>Nimmt die Farbe, die angeklickt wird, und geht zum Pinsel zurück</translation>
    </message>
    <message>
        <source>The wheel zooms, the middle button moves the picture. A double click or Enter closes a polygon. Alt and a click takes the colour there, Alt and a number that of the palette; [ and ] make the brush smaller and larger. Without a mouse: Shift and the arrow keys move the cursor, the space bar paints, fills or sets a corner.</source>
        <translation>Das Rad zoomt, die mittlere Taste verschiebt das Bild. Ein Doppelklick oder die Eingabetaste schließt ein Polygon. Alt und ein Klick nimmt die Farbe dort, Alt und eine Ziffer die der Palette; [ und ] machen den Pinsel kleiner und größer. Ohne Maus: Umschalt und die Pfeiltasten bewegen den Cursor, die Leertaste malt, füllt oder setzt eine Ecke.</translation>
    </message>
    <message>
        <source>Colour %1</source>
        <translation>Farbe %1</translation>
    </message>
    <message>
        <source>Colour %1 (Alt+%1)</source>
        <translation>Farbe %1 (Alt+%1)</translation>
    </message>
    <message>
        <source>How much of the picture shows through the colours</source>
        <translation>Wie viel vom Bild durch die Farben scheint</translation>
    </message>
    <message>
        <source>Picture &amp;shows</source>
        <translation>Bild &amp;scheint durch</translation>
    </message>
    <message>
        <source>Paint &amp;all</source>
        <translation>&amp;Alles bemalen</translation>
    </message>
    <message>
        <source>Paints the whole picture in the colour</source>
        <translation>Malt das ganze Bild in der Farbe</translation>
    </message>
</context>
<context>
    <name>texloom::ui::LatticeFields</name>
    <message>
        <source>First vector</source>
        <translation>Erster Vektor</translation>
    </message>
    <message>
        <source>Second vector</source>
        <translation>Zweiter Vektor</translation>
    </message>
    <message>
        <source>Origin</source>
        <translation>Ursprung</translation>
    </message>
    <message>
        <source>right, px</source>
        <translation>nach rechts, px</translation>
    </message>
    <message>
        <source>down, px</source>
        <translation>nach unten, px</translation>
    </message>
    <message>
        <source>%1, right</source>
        <translation>%1, nach rechts</translation>
    </message>
    <message>
        <source>%1, down</source>
        <translation>%1, nach unten</translation>
    </message>
    <message>
        <source>Where a tile begins. The methods choose by themselves until it is moved.</source>
        <translation>Wo eine Kachel beginnt. Die Verfahren wählen selbst, bis er bewegt wird.</translation>
    </message>
</context>
<context>
    <name>texloom::ui::LatticeSearchForm</name>
    <message>
        <source>Advanced</source>
        <translation>Erweitert</translation>
    </message>
    <message>
        <source>What decides between lattices when one is looked for</source>
        <translation>Was bei der Suche zwischen Gittern entscheidet</translation>
    </message>
</context>
<context>
    <name>texloom::ui::LatticeTool</name>
    <message>
        <source>Exemplar with its lattice</source>
        <translation>Vorlage mit ihrem Gitter</translation>
    </message>
    <message>
        <source>Open an exemplar to find its lattice.</source>
        <translation>Öffnen Sie eine Vorlage, um ihr Gitter zu finden.</translation>
    </message>
    <message>
        <source>Correlation of the exemplar with itself</source>
        <translation>Korrelation der Vorlage mit sich selbst</translation>
    </message>
    <message>
        <source>How alike the exemplar is to itself when it is moved: bright where it repeats. The lattice&apos;s points belong on the bright spots.</source>
        <translation>Wie ähnlich die verschobene Vorlage sich selbst ist: hell, wo sie sich wiederholt. Die Gitterpunkte gehören auf die hellen Flecken.</translation>
    </message>
    <message>
        <source>The correlation of the exemplar with itself shows here.</source>
        <translation>Hier erscheint die Korrelation der Vorlage mit sich selbst.</translation>
    </message>
    <message>
        <source>Detect</source>
        <translation>Erkennen</translation>
    </message>
    <message>
        <source>Look for the lattice in the exemplar again</source>
        <translation>Das Gitter in der Vorlage noch einmal suchen</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Anpassen</translation>
    </message>
    <message>
        <source>Move the vectors so that all their multiples come nearest to the bright spots</source>
        <translation>Die Vektoren so bewegen, dass alle ihre Vielfachen den hellen Flecken am nächsten kommen</translation>
    </message>
    <message>
        <source>Looking for the lattice…</source>
        <translation>Gitter wird gesucht …</translation>
    </message>
    <message>
        <source>Use in %1</source>
        <translation>In %1 benutzen</translation>
    </message>
    <message>
        <source>%1 follows no lattice.</source>
        <translation>%1 folgt keinem Gitter.</translation>
    </message>
    <message>
        <source>%1 is set to use no lattice.</source>
        <translation>%1 ist ohne Gitter eingestellt.</translation>
    </message>
    <message>
        <source>%1 looks for the lattice by itself.</source>
        <translation>%1 sucht das Gitter selbst.</translation>
    </message>
    <message>
        <source>✓ %1 uses this lattice.</source>
        <translation>✓ %1 benutzt dieses Gitter.</translation>
    </message>
    <message>
        <source>%1 uses another lattice: %2 and %3 px.</source>
        <translation>%1 benutzt ein anderes Gitter: %2 und %3 px.</translation>
    </message>
    <message>
        <source>Open an exemplar first.</source>
        <translation>Öffnen Sie zuerst eine Vorlage.</translation>
    </message>
    <message>
        <source>Press Detect to look for the lattice, or give its vectors.</source>
        <translation>Drücken Sie „Erkennen“, um das Gitter zu suchen, oder geben Sie seine Vektoren an.</translation>
    </message>
    <message>
        <source>%1 repeats itself by this lattice (confidence %2).</source>
        <translation>%1 wiederholt sich nach diesem Gitter (Sicherheit %2).</translation>
    </message>
    <message>
        <source> The exemplar holds fewer than two of these tiles on a side, so results repeat much of it.</source>
        <translation> Die Vorlage fasst je Seite weniger als zwei dieser Kacheln, daher wiederholen Ergebnisse viel davon.</translation>
    </message>
    <message>
        <source>%1 repeats itself in rows (confidence %2); what lies along them may come from anywhere in a row.</source>
        <translation>%1 wiederholt sich in Reihen (Sicherheit %2); was in ihnen liegt, darf von irgendwo in einer Reihe kommen.</translation>
    </message>
    <message>
        <source>Nothing in %1 repeats itself, but rows run through all of it (confidence %2): they keep their order, and begin again after %3 px. If you see it repeat, rectify the exemplar first (Ctrl+D) where it is seen at an angle, or drag the vectors.</source>
        <translation>Nichts in %1 wiederholt sich, aber Reihen laufen durch alles hindurch (Sicherheit %2): Sie behalten ihre Reihenfolge und beginnen nach %3 px von vorn. Wenn Sie sehen, dass es sich wiederholt, entzerren Sie die Vorlage zuerst (Strg+D), wo sie schräg gesehen ist, oder ziehen Sie die Vektoren.</translation>
    </message>
    <message>
        <source>Nothing in %1 repeats itself. A vector must fit into the exemplar about twice to be found. If you see it repeat, give the vectors, or rectify the exemplar first (Ctrl+D) where it is seen at an angle; if not, methods without a lattice suit it, such as image quilting.</source>
        <translation>Nichts in %1 wiederholt sich. Ein Vektor muss etwa zweimal in die Vorlage passen, um gefunden zu werden. Wenn Sie eine Wiederholung sehen, geben Sie die Vektoren an, oder entzerren Sie die Vorlage zuerst (Strg+D), wo sie schräg gesehen ist; wenn nicht, passen Verfahren ohne Gitter, etwa Bild-Quilting.</translation>
    </message>
    <message>
        <source>No lattice stands out in %1 (confidence %2). Choose one below, drag the vectors to what you see, or rectify the exemplar first (Ctrl+D) where it is seen at an angle; if it does not repeat, methods without a lattice suit it, such as image quilting.</source>
        <translation>In %1 sticht kein Gitter hervor (Sicherheit %2). Wählen Sie unten eines, ziehen Sie die Vektoren auf das, was Sie sehen, oder entzerren Sie die Vorlage zuerst (Strg+D), wo sie schräg gesehen ist; wenn sich nichts wiederholt, passen Verfahren ohne Gitter, etwa Bild-Quilting.</translation>
    </message>
    <message>
        <source>Set by hand: %1 agrees with itself by %2 at the multiples of these vectors; by %3 at those of the best that was found.</source>
        <translation>Von Hand gesetzt: %1 stimmt an den Vielfachen dieser Vektoren zu %2 mit sich überein; an denen des besten gefundenen zu %3.</translation>
    </message>
</context>
<context>
    <name>texloom::ui::LayerDialog</name>
    <message>
        <source>Page %1</source>
        <translation>Seite %1</translation>
    </message>
    <message>
        <source>Part %1</source>
        <translation>Teil %1</translation>
    </message>
    <message>
        <source>All channels</source>
        <translation>Alle Kanäle</translation>
    </message>
    <message>
        <source>Choose a layer</source>
        <translation>Ebene wählen</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Ebenen</translation>
    </message>
    <message>
        <source>%1 holds several pictures. Which one is to be taken?</source>
        <translation>%1 enthält mehrere Bilder. Welches soll genommen werden?</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
</context>
<context>
    <name>texloom::ui::LimitsDialog</name>
    <message>
        <source>The latest results stay in memory up to this; others are read from the disk when they are shown.</source>
        <translation>Die neuesten Ergebnisse bleiben bis zu dieser Menge im Speicher; andere werden beim Zeigen vom Datenträger gelesen.</translation>
    </message>
    <message>
        <source>Beyond this the oldest results are removed; those pinned stay.</source>
        <translation>Darüber hinaus werden die ältesten Ergebnisse entfernt; angeheftete bleiben.</translation>
    </message>
    <message>
        <source>Limits for results</source>
        <translation>Grenzen für Ergebnisse</translation>
    </message>
    <message>
        <source>In &amp;memory</source>
        <translation>Im &amp;Speicher</translation>
    </message>
    <message>
        <source>On the &amp;disk</source>
        <translation>Auf dem &amp;Datenträger</translation>
    </message>
    <message>
        <source>Kept in</source>
        <translation>Aufbewahrt in</translation>
    </message>
    <message>
        <source> GiB</source>
        <translation> GiB</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Jetzt</translation>
    </message>
    <message>
        <source>%1 in memory, %2 on the disk</source>
        <translation>%1 im Speicher, %2 auf der Platte</translation>
    </message>
    <message>
        <source>&amp;Show the folder</source>
        <translation>&amp;Ordner zeigen</translation>
    </message>
</context>
<context>
    <name>texloom::ui::LogPanel</name>
    <message>
        <source>Log</source>
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>What is run, and what goes wrong, is noted here.</source>
        <translation>Was ausgeführt wird und was schiefgeht, steht hier.</translation>
    </message>
    <message>
        <source>Copy all</source>
        <translation>Alles kopieren</translation>
    </message>
    <message>
        <source>Copy the whole log, for a report</source>
        <translation>Das ganze Protokoll kopieren, für eine Meldung</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Leeren</translation>
    </message>
    <message>
        <source>Take all lines off the log</source>
        <translation>Alle Zeilen aus dem Protokoll nehmen</translation>
    </message>
    <message>
        <source>%1  %2</source>
        <translation>%1  %2</translation>
    </message>
</context>
<context>
    <name>texloom::ui::MainWindow</name>
    <message>
        <source>Texloom</source>
        <translation>Texloom</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>Exemplars</source>
        <translation>Vorlagen</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>Zuletzt &amp;geöffnet</translation>
    </message>
    <message>
        <source>&amp;Samples</source>
        <translation>&amp;Beispiele</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>E&amp;xemplar</source>
        <translation>&amp;Vorlage</translation>
    </message>
    <message>
        <source>&amp;Synthesis</source>
        <translation>&amp;Synthese</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Appearance</source>
        <translation>&amp;Erscheinungsbild</translation>
    </message>
    <message>
        <source>As the &amp;desktop</source>
        <translation>Wie der &amp;Desktop</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Hell</translation>
    </message>
    <message>
        <source>Da&amp;rk</source>
        <translation>&amp;Dunkel</translation>
    </message>
    <message>
        <source>Toolbar</source>
        <translation>Werkzeugleiste</translation>
    </message>
    <message>
        <source>%1 holds the settings of a result.</source>
        <translation>%1 enthält die Einstellungen eines Ergebnisses.</translation>
    </message>
    <message>
        <source>Open exemplars</source>
        <translation>Vorlagen öffnen</translation>
    </message>
    <message>
        <source>Nothing opened yet</source>
        <translation>Noch nichts geöffnet</translation>
    </message>
    <message>
        <source>Only files on this computer can be opened; save the picture first, then drop its file.</source>
        <translation>Nur Dateien auf diesem Rechner können geöffnet werden; speichern Sie das Bild zuerst und ziehen Sie dann die Datei herein.</translation>
    </message>
    <message>
        <source>There is no picture in what was pasted; copy a picture or a picture file first.</source>
        <translation>Im Eingefügten ist kein Bild; kopieren Sie zuerst ein Bild oder eine Bilddatei.</translation>
    </message>
    <message>
        <source>Let go to open it as an exemplar.</source>
        <translation>Loslassen, um es als Vorlage zu öffnen.</translation>
    </message>
    <message>
        <source>%1 was made here and holds its settings.</source>
        <translation>%1 ist hier entstanden und enthält seine Einstellungen.</translation>
    </message>
    <message>
        <source>Restore settings</source>
        <translation>Einstellungen wiederherstellen</translation>
    </message>
    <message>
        <source>Settings restored, but these files changed since, so the result will differ: %1.</source>
        <translation>Einstellungen wiederhergestellt, aber diese Dateien haben sich seither geändert, sodass das Ergebnis anders ausfällt: %1.</translation>
    </message>
    <message>
        <source>About Texloom</source>
        <translation>Über Texloom</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Texloom %1&lt;/h3&gt;&lt;p&gt;A workbench for exemplar-based texture synthesis.&lt;/p&gt;&lt;p&gt;Free software under the GNU General Public License, version 3 or later.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Texloom %1&lt;/h3&gt;&lt;p&gt;Eine Werkbank für Textursynthese nach Vorlagen.&lt;/p&gt;&lt;p&gt;Freie Software unter der GNU General Public License, Version 3 oder später.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Reading the picture…</source>
        <translation>Das Bild wird gelesen …</translation>
    </message>
    <message>
        <source>Open an exemplar first.</source>
        <translation>Öffnen Sie zuerst eine Vorlage.</translation>
    </message>
    <message>
        <source>%1[*] – Texloom</source>
        <translation>%1[*] – Texloom</translation>
    </message>
    <message>
        <source>Lattice</source>
        <translation>Gitter</translation>
    </message>
    <message>
        <source>The vectors by which the exemplar repeats itself: found, corrected, and given to the method.</source>
        <translation>Die Vektoren, um die sich die Vorlage wiederholt: gefunden, berichtigt und dem Verfahren gegeben.</translation>
    </message>
    <message>
        <source>Figures</source>
        <translation>Kennzahlen</translation>
    </message>
    <message>
        <source>&amp;Tools</source>
        <translation>&amp;Werkzeuge</translation>
    </message>
    <message>
        <source>Result: %1</source>
        <translation>Ergebnis: %1</translation>
    </message>
    <message>
        <source>Open an exemplar first: its patches are compared with each other.</source>
        <translation>Öffnen Sie zuerst eine Vorlage: Ihre Patches werden miteinander verglichen.</translation>
    </message>
    <message>
        <source>Earlier: %1</source>
        <translation>Früher: %1</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergleich</translation>
    </message>
    <message>
        <source>Several results and exemplars beside one another.</source>
        <translation>Mehrere Ergebnisse und Vorlagen nebeneinander.</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>Ergebnisse</translation>
    </message>
    <message>
        <source>Jobs</source>
        <translation>Aufträge</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>The recipe was made by Texloom %1; this is %2, so the result may differ.</source>
        <translation>Das Rezept stammt von Texloom %1; dies ist %2, daher kann das Ergebnis abweichen.</translation>
    </message>
    <message>
        <source>Stopped. One run that waited was given up.</source>
        <translation>Angehalten. Ein wartender Lauf wurde aufgegeben.</translation>
    </message>
    <message>
        <source>Stopped. %1 runs that waited were given up.</source>
        <translation>Angehalten. %1 wartende Läufe wurden aufgegeben.</translation>
    </message>
    <message>
        <source>Maps of the same material lie beside it: %1.</source>
        <translation>Daneben liegen Karten desselben Materials: %1.</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>There is a preset %1 already.</source>
        <translation>Eine Vorgabe %1 gibt es schon.</translation>
    </message>
    <message>
        <source>Replace it</source>
        <translation>Ersetzen</translation>
    </message>
    <message>
        <source>The session was saved by Texloom %1; this is %2, so results may differ.</source>
        <translation>Die Sitzung wurde von Texloom %1 gespeichert; dies ist %2, daher können Ergebnisse abweichen.</translation>
    </message>
    <message>
        <source>S&amp;olids</source>
        <translation>K&amp;örper</translation>
    </message>
    <message>
        <source>A generator that was trained already: look at it in the Volume tab.</source>
        <translation>Ein Generator, der schon trainiert ist: im Reiter Volumen zu sehen.</translation>
    </message>
    <message>
        <source>&amp;Open a solid…</source>
        <translation>Körper ö&amp;ffnen …</translation>
    </message>
    <message>
        <source>Solid to look at</source>
        <translation>Körper zum Ansehen</translation>
    </message>
    <message>
        <source>Generators and volumes (*.safetensors *.json);;Slices of a volume (*.png *.tif *.exr)</source>
        <translation>Generatoren und Volumen (*.safetensors *.json);;Schnitte eines Volumens (*.png *.tif *.exr)</translation>
    </message>
</context>
<context>
    <name>texloom::ui::MapDeriver</name>
    <message>
        <source>Deri&amp;ve a map</source>
        <translation>Karte a&amp;bleiten</translation>
    </message>
    <message>
        <source>&amp;Normal from height</source>
        <translation>&amp;Normalen aus Höhen</translation>
    </message>
    <message>
        <source>Makes the normal map that belongs to the height map.</source>
        <translation>Macht die Normalenkarte, die zur Höhenkarte gehört.</translation>
    </message>
    <message>
        <source>&amp;Height from normal</source>
        <translation>&amp;Höhen aus Normalen</translation>
    </message>
    <message>
        <source>Integrates the slopes of the normal map; how deep the relief is cannot be told from it.</source>
        <translation>Integriert die Neigungen der Normalenkarte; wie tief das Relief ist, sagt sie nicht.</translation>
    </message>
    <message>
        <source>&amp;Roughness, a first guess</source>
        <translation>&amp;Rauheit, ein erster Anhalt</translation>
    </message>
    <message>
        <source>Bright and pale places are taken as smooth, dark ones as rough: a start, to be corrected by hand.</source>
        <translation>Helle und blasse Stellen gelten als glatt, dunkle als rau: ein Anfang, der von Hand zu verbessern ist.</translation>
    </message>
    <message>
        <source>&amp;Occlusion, a first guess</source>
        <translation>&amp;Verdeckung, ein erster Anhalt</translation>
    </message>
    <message>
        <source>Places that lie below their surroundings in the height map are darkened.</source>
        <translation>Stellen, die in der Höhenkarte tiefer als ihre Umgebung liegen, werden abgedunkelt.</translation>
    </message>
</context>
<context>
    <name>texloom::ui::MapPage</name>
    <message>
        <source>Estimate the map</source>
        <translation>Karte schätzen</translation>
    </message>
    <message>
        <source>Look for the place in the exemplar that each pixel of the result is most like</source>
        <translation>Die Stelle der Vorlage suchen, der jedes Pixel des Ergebnisses am ähnlichsten ist</translation>
    </message>
    <message>
        <source>Estimating the map…</source>
        <translation>Karte wird geschätzt …</translation>
    </message>
</context>
<context>
    <name>texloom::ui::MaskPainter</name>
    <message>
        <source>&amp;Take away</source>
        <translation>&amp;Wegnehmen</translation>
    </message>
    <message>
        <source>The wheel zooms, the middle button moves the picture. A double click or Enter closes a polygon. Alt takes away; [ and ] make the brush smaller and larger. Without a mouse: Shift and the arrow keys move the cursor, the space bar paints or sets a corner.</source>
        <translation>Das Rad zoomt, die mittlere Taste verschiebt das Bild. Ein Doppelklick oder die Eingabetaste schließt ein Polygon. Alt nimmt weg; [ und ] machen den Pinsel kleiner und größer. Ohne Maus: Umschalt und die Pfeiltasten bewegen den Cursor, die Leertaste malt oder setzt eine Ecke.</translation>
    </message>
    <message>
        <source>Shapes are taken away from what is painted. Alt does the same for one shape.</source>
        <translation>Formen werden von dem weggenommen, was gemalt ist. Alt tut dasselbe für eine Form.</translation>
    </message>
    <message>
        <source>Painted: black in the mask, lighter where it is softened.</source>
        <translation>Gemalt: schwarz in der Maske, heller, wo es weichgezeichnet ist.</translation>
    </message>
    <message>
        <source>Pixels by which edges are moved</source>
        <translation>Pixel, um die Kanten verschoben werden</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>By how many pixels the buttons below grow, shrink or soften what is painted.</source>
        <translation>Um wie viele Pixel die Knöpfe darunter wachsen lassen, schrumpfen oder weichzeichnen, was gemalt ist.</translation>
    </message>
    <message>
        <source>Edges by</source>
        <translation>Kanten um</translation>
    </message>
    <message>
        <source>&amp;Grow</source>
        <translation>W&amp;achsen</translation>
    </message>
    <message>
        <source>Paints further, by so many pixels</source>
        <translation>Malt um so viele Pixel weiter</translation>
    </message>
    <message>
        <source>&amp;Shrink</source>
        <translation>&amp;Schrumpfen</translation>
    </message>
    <message>
        <source>Paints less far, by so many pixels</source>
        <translation>Malt um so viele Pixel weniger weit</translation>
    </message>
    <message>
        <source>&amp;Feather</source>
        <translation>Weich&amp;zeichnen</translation>
    </message>
    <message>
        <source>Softens the edge outwards, over so many pixels: what was painted stays whole</source>
        <translation>Macht den Rand nach außen weich, über so viele Pixel: was gemalt war, bleibt ganz</translation>
    </message>
    <message>
        <source>&amp;Invert</source>
        <translation>&amp;Umkehren</translation>
    </message>
    <message>
        <source>Paints what is not painted, and nothing else</source>
        <translation>Malt, was nicht gemalt ist, und sonst nichts</translation>
    </message>
    <message>
        <source>Cl&amp;ear</source>
        <translation>L&amp;eeren</translation>
    </message>
    <message>
        <source>Takes all away that is painted</source>
        <translation>Nimmt alles weg, was gemalt ist</translation>
    </message>
</context>
<context>
    <name>texloom::ui::MaterialPage</name>
    <message>
        <source>Drag to turn it, with the middle button to move it, with Shift and the right button to turn the light; the wheel comes nearer. C shows the maps alone, M the material, F frames it, R resets.</source>
        <translation>Ziehen dreht es, mit der mittleren Taste wird es verschoben, mit Umschalt und der rechten dreht sich das Licht; das Rad kommt näher. C zeigt die Karten allein, M das Material, F rückt es ins Bild, R setzt zurück.</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>Ebene</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>Kugel</translation>
    </message>
    <message>
        <source>Cube</source>
        <translation>Würfel</translation>
    </message>
    <message>
        <source>Cylinder</source>
        <translation>Zylinder</translation>
    </message>
    <message>
        <source>Mesh from a file…</source>
        <translation>Netz aus einer Datei …</translation>
    </message>
    <message>
        <source>Studio lights</source>
        <translation>Studiolicht</translation>
    </message>
    <message>
        <source>Courtyard</source>
        <translation>Innenhof</translation>
    </message>
    <message>
        <source>Studio room</source>
        <translation>Studioraum</translation>
    </message>
    <message>
        <source>Sunset</source>
        <translation>Sonnenuntergang</translation>
    </message>
    <message>
        <source>Panorama from a file…</source>
        <translation>Panorama aus einer Datei …</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>Normalen</translation>
    </message>
    <message>
        <source>Roughness</source>
        <translation>Rauheit</translation>
    </message>
    <message>
        <source>Metallic</source>
        <translation>Metallisch</translation>
    </message>
    <message>
        <source>Occlusion</source>
        <translation>Verdeckung</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source>Grey</source>
        <translation>Grau</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Licht</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>From the lowest height to the highest, as a share of the maps&apos; side; needs a height map</source>
        <translation>Von der geringsten Höhe zur größten, als Anteil der Seite der Karten; braucht eine Höhenkarte</translation>
    </message>
    <message>
        <source> stops</source>
        <translation> Blenden</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>Repeat</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Relief</source>
        <translation>Relief</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>Lit by</source>
        <translation>Beleuchtet von</translation>
    </message>
    <message>
        <source>Turned by</source>
        <translation>Gedreht um</translation>
    </message>
    <message>
        <source>Exposure</source>
        <translation>Belichtung</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Hintergrund</translation>
    </message>
    <message>
        <source>Save picture…</source>
        <translation>Bild speichern …</translation>
    </message>
    <message>
        <source>Turntable…</source>
        <translation>Rundumbilder …</translation>
    </message>
    <message>
        <source>Mesh to show the material on</source>
        <translation>Netz, auf dem das Material gezeigt wird</translation>
    </message>
    <message>
        <source>Meshes (*.obj *.ply *.gltf *.glb)</source>
        <translation>Netze (*.obj *.ply *.gltf *.glb)</translation>
    </message>
    <message>
        <source>Panorama to light the material by</source>
        <translation>Panorama, das das Material beleuchtet</translation>
    </message>
    <message>
        <source>Pictures (*.exr *.hdr *.tif *.png *.jpg)</source>
        <translation>Bilder (*.exr *.hdr *.tif *.png *.jpg)</translation>
    </message>
    <message>
        <source>Save the picture of the material</source>
        <translation>Bild des Materials speichern</translation>
    </message>
    <message>
        <source>Pictures (*.png *.exr *.tif *.jpg)</source>
        <translation>Bilder (*.png *.exr *.tif *.jpg)</translation>
    </message>
    <message>
        <source>Folder for the pictures of a turn</source>
        <translation>Ordner für die Bilder einer Umdrehung</translation>
    </message>
    <message>
        <source>There is no material to save a picture of yet; press Run first.</source>
        <translation>Es gibt noch kein Material, von dem ein Bild gespeichert werden könnte; drücken Sie zuerst Ausführen.</translation>
    </message>
    <message>
        <source>Writing %1 pictures of a turn</source>
        <translation>%1 Bilder einer Umdrehung werden geschrieben</translation>
    </message>
</context>
<context>
    <name>texloom::ui::MaterialView</name>
    <message>
        <source>Material</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>Drawing…</source>
        <translation>Wird gezeichnet …</translation>
    </message>
    <message>
        <source>No result yet. Press Run.</source>
        <translation>Noch kein Ergebnis. Drücken Sie „Ausführen“.</translation>
    </message>
</context>
<context>
    <name>texloom::ui::MessageBar</name>
    <message>
        <source>Close message</source>
        <translation>Meldung schließen</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Information</source>
        <translation>Hinweis</translation>
    </message>
</context>
<context>
    <name>texloom::ui::MethodForm</name>
    <message>
        <source>Only used while “%1” is %2.</source>
        <translation>Nur benutzt, solange „%1“ %2 ist.</translation>
    </message>
</context>
<context>
    <name>texloom::ui::MethodHint</name>
    <message>
        <source>Methods that suit the exemplar</source>
        <translation>Verfahren, die zur Vorlage passen</translation>
    </message>
    <message>
        <source>Try first: %1. %2</source>
        <translation>Zuerst versuchen: %1. %2</translation>
    </message>
</context>
<context>
    <name>texloom::ui::MethodsDialog</name>
    <message>
        <source>At a &amp;preview&apos;s size, not at %1 px</source>
        <translation>In der Größe einer &amp;Vorschau, nicht mit %1 px</translation>
    </message>
    <message>
        <source>Try some methods</source>
        <translation>Einige Verfahren ausprobieren</translation>
    </message>
    <message>
        <source>Methods to try</source>
        <translation>Verfahren zum Ausprobieren</translation>
    </message>
    <message>
        <source>Makes a run with each method ticked and shows them side by side.</source>
        <translation>Macht mit jedem angekreuzten Verfahren einen Lauf und zeigt sie nebeneinander.</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Beginnen</translation>
    </message>
</context>
<context>
    <name>texloom::ui::MissingFilesDialog</name>
    <message>
        <source>&amp;Find…</source>
        <translation>&amp;Suchen …</translation>
    </message>
    <message>
        <source>Missing files</source>
        <translation>Fehlende Dateien</translation>
    </message>
    <message>
        <source>Says where the chosen file is now; others that lie beside it are found with it.</source>
        <translation>Sagt, wo die gewählte Datei jetzt ist; andere, die daneben liegen, werden mitgefunden.</translation>
    </message>
    <message>
        <source>Where is %1?</source>
        <translation>Wo ist %1?</translation>
    </message>
    <message>
        <source>%1 (%1);;All files (*)</source>
        <translation>%1 (%1);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>All files were found.</source>
        <translation>Alle Dateien wurden gefunden.</translation>
    </message>
    <message>
        <source>These files of the session are not where they were. Say where they are, or go on without them; everything else is kept.</source>
        <translation>Diese Dateien der Sitzung sind nicht mehr, wo sie waren. Sagen Sie, wo sie sind, oder fahren Sie ohne sie fort; alles andere bleibt erhalten.</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>Ö&amp;ffnen</translation>
    </message>
    <message>
        <source>&amp;Go on without them</source>
        <translation>&amp;Ohne sie fortfahren</translation>
    </message>
</context>
<context>
    <name>texloom::ui::Navigator</name>
    <message>
        <source>The whole picture. Drag the frame to look elsewhere; N shows and hides this.</source>
        <translation>Das ganze Bild. Den Rahmen ziehen, um anderswo hinzusehen; N zeigt und verbirgt es.</translation>
    </message>
</context>
<context>
    <name>texloom::ui::NumbersEditor</name>
    <message>
        <source>%1, across</source>
        <translation>%1, waagerecht</translation>
    </message>
    <message>
        <source>%1, down</source>
        <translation>%1, senkrecht</translation>
    </message>
    <message>
        <source>auto</source>
        <translation>auto</translation>
    </message>
    <message>
        <source>Left, top</source>
        <translation>Links, oben</translation>
    </message>
    <message>
        <source>Width, height</source>
        <translation>Breite, Höhe</translation>
    </message>
    <message>
        <source>Point %1</source>
        <translation>Punkt %1</translation>
    </message>
</context>
<context>
    <name>texloom::ui::OutputGroup</name>
    <message>
        <source>Output</source>
        <translation>Ausgabe</translation>
    </message>
    <message>
        <source>across (X)</source>
        <translation>waagrecht (X)</translation>
    </message>
    <message>
        <source>down (Y)</source>
        <translation>senkrecht (Y)</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>&lt;b&gt;Threads&lt;/b&gt; How many of the processor&apos;s cores a run uses. The result is the same with any number. Automatic: one for each core.</source>
        <translation>&lt;b&gt;Threads&lt;/b&gt; Wie viele Kerne des Prozessors ein Vorgang benutzt. Das Ergebnis ist bei jeder Zahl dasselbe. Automatisch: einer je Kern.</translation>
    </message>
    <message>
        <source>S&amp;ize</source>
        <translation>&amp;Größe</translation>
    </message>
    <message>
        <source>Wraps</source>
        <translation>Kachelbar</translation>
    </message>
    <message>
        <source>See&amp;d</source>
        <translation>Startwe&amp;rt</translation>
    </message>
    <message>
        <source>&amp;Threads</source>
        <translation>&amp;Threads</translation>
    </message>
    <message>
        <source>&lt;b&gt;Size&lt;/b&gt; Width and height of the result in pixels, 1 to %1 each.</source>
        <translation>&lt;b&gt;Größe&lt;/b&gt; Breite und Höhe des Ergebnisses in Pixeln, je 1 bis %1.</translation>
    </message>
    <message>
        <source>×</source>
        <translation>×</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>×%1</source>
        <translation>×%1</translation>
    </message>
    <message>
        <source>%1 times the exemplar&apos;s size</source>
        <translation>%1-mal die Größe der Vorlage</translation>
    </message>
    <message>
        <source>&lt;b&gt;×%1&lt;/b&gt; Makes the result %1 times as wide and as high as the exemplar.</source>
        <translation>&lt;b&gt;×%1&lt;/b&gt; Macht das Ergebnis %1-mal so breit und so hoch wie die Vorlage.</translation>
    </message>
    <message>
        <source>of the exemplar</source>
        <translation>der Vorlage</translation>
    </message>
    <message>
        <source>Wraps across</source>
        <translation>Waagrecht kachelbar</translation>
    </message>
    <message>
        <source>Wraps down</source>
        <translation>Senkrecht kachelbar</translation>
    </message>
    <message>
        <source>&lt;b&gt;Seed&lt;/b&gt; Where the random choices begin. The same seed and settings give the same pixels.</source>
        <translation>&lt;b&gt;Startwert&lt;/b&gt; Wo die Zufallswahl beginnt. Derselbe Startwert und dieselben Einstellungen geben dieselben Pixel.</translation>
    </message>
    <message>
        <source>Draw a new seed</source>
        <translation>Neuen Startwert ziehen</translation>
    </message>
    <message>
        <source>Keep the seed</source>
        <translation>Startwert behalten</translation>
    </message>
    <message>
        <source>&lt;b&gt;Keep the seed&lt;/b&gt; On: every run uses this seed. Off: every run draws a new one.</source>
        <translation>&lt;b&gt;Startwert behalten&lt;/b&gt; Ein: jeder Vorgang benutzt diesen Startwert. Aus: jeder zieht einen neuen.</translation>
    </message>
    <message>
        <source>left and right edges</source>
        <translation>linker und rechter Rand</translation>
    </message>
    <message>
        <source>upper and lower edges</source>
        <translation>oberer und unterer Rand</translation>
    </message>
    <message>
        <source>&lt;b&gt;Wraps&lt;/b&gt; The result&apos;s %1 join without a seam when it is repeated.</source>
        <translation>&lt;b&gt;Kachelbar&lt;/b&gt; Beim Wiederholen des Ergebnisses (%1) entsteht keine Naht.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Wraps&lt;/b&gt; %1 cannot make a result that wraps.</source>
        <translation>&lt;b&gt;Kachelbar&lt;/b&gt; %1 kann kein kachelbares Ergebnis erzeugen.</translation>
    </message>
    <message>
        <source>Make</source>
        <translation>Erzeugen</translation>
    </message>
    <message>
        <source>&lt;b&gt;Only a part&lt;/b&gt; Makes a rectangle of the output, which equals that part of the whole.</source>
        <translation>&lt;b&gt;Nur ein Teil&lt;/b&gt; Erzeugt ein Rechteck der Ausgabe, das diesem Teil des Ganzen gleicht.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Only a part&lt;/b&gt; %1 can only make the whole.</source>
        <translation>&lt;b&gt;Nur ein Teil&lt;/b&gt; %1 kann nur das Ganze erzeugen.</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Startwert</translation>
    </message>
    <message>
        <source>A</source>
        <translation>A</translation>
    </message>
    <message>
        <source>B</source>
        <translation>B</translation>
    </message>
</context>
<context>
    <name>texloom::ui::Painter</name>
    <message>
        <source>Picture that is painted on</source>
        <translation>Bild, auf das gemalt wird</translation>
    </message>
    <message>
        <source>&amp;Brush</source>
        <translation>&amp;Pinsel</translation>
    </message>
    <message>
        <source>Paints where the mouse drags</source>
        <translation>Malt, wo die Maus zieht</translation>
    </message>
    <message>
        <source>&amp;Lasso</source>
        <translation>&amp;Lasso</translation>
    </message>
    <message>
        <source>Takes what the mouse drags around</source>
        <translation>Nimmt, was die Maus umfährt</translation>
    </message>
    <message>
        <source>&amp;Polygon</source>
        <translation>Pol&amp;ygon</translation>
    </message>
    <message>
        <source>Gets a corner at each click</source>
        <translation>Bekommt mit jedem Klick eine Ecke</translation>
    </message>
    <message>
        <source>&amp;Rectangle</source>
        <translation>&amp;Rechteck</translation>
    </message>
    <message>
        <source>Goes from corner to corner</source>
        <translation>Geht von Ecke zu Ecke</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>&amp;Breite</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>Rück&amp;gängig</translation>
    </message>
    <message>
        <source>Goes back by a step (Ctrl+Z)</source>
        <translation>Geht einen Schritt zurück (Strg+Z)</translation>
    </message>
    <message>
        <source>Re&amp;do</source>
        <translation>Wieder&amp;herstellen</translation>
    </message>
    <message>
        <source>Makes an undone step again (Ctrl+Shift+Z)</source>
        <translation>Macht einen zurückgenommenen Schritt wieder (Strg+Umschalt+Z)</translation>
    </message>
    <message>
        <source>Painted and not kept</source>
        <translation>Gemalt und nicht behalten</translation>
    </message>
    <message>
        <source>What you painted is lost unless you keep it.</source>
        <translation>Was Sie gemalt haben, geht verloren, wenn Sie es nicht behalten.</translation>
    </message>
    <message>
        <source>&amp;Keep</source>
        <translation>&amp;Behalten</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>Ver&amp;werfen</translation>
    </message>
    <message>
        <source>&amp;Go on painting</source>
        <translation>&amp;Weiter malen</translation>
    </message>
</context>
<context>
    <name>texloom::ui::ParamRow</name>
    <message>
        <source>on</source>
        <translation>ein</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>Reset “%1” to its default</source>
        <translation>„%1“ auf den Standard zurücksetzen</translation>
    </message>
    <message>
        <source>Default: %1.</source>
        <translation>Standard: %1.</translation>
    </message>
    <message>
        <source>Default: %1 % of the exemplar&apos;s shorter side.</source>
        <translation>Standard: %1 % der kürzeren Seite der Vorlage.</translation>
    </message>
    <message>
        <source>Default: %1 % of the exemplar&apos;s shorter side, here %2.</source>
        <translation>Standard: %1 % der kürzeren Seite der Vorlage, hier %2.</translation>
    </message>
    <message>
        <source> (%1 in the paper)</source>
        <translation> (%1 im Artikel)</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt; %2</source>
        <translation>&lt;b&gt;%1&lt;/b&gt; %2</translation>
    </message>
    <message>
        <source> %1.</source>
        <translation> %1.</translation>
    </message>
</context>
<context>
    <name>texloom::ui::PartEditor</name>
    <message>
        <source>only a part</source>
        <translation>nur ein Teil</translation>
    </message>
    <message>
        <source>Part&apos;s left</source>
        <translation>Links des Teils</translation>
    </message>
    <message>
        <source>Part&apos;s top</source>
        <translation>Oben des Teils</translation>
    </message>
    <message>
        <source>Part&apos;s width</source>
        <translation>Breite des Teils</translation>
    </message>
    <message>
        <source>Part&apos;s height</source>
        <translation>Höhe des Teils</translation>
    </message>
    <message>
        <source>at</source>
        <translation>bei</translation>
    </message>
    <message>
        <source>size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>%1, in pixels of the whole</source>
        <translation>%1, in Pixeln des Ganzen</translation>
    </message>
</context>
<context>
    <name>texloom::ui::Plot</name>
    <message>
        <source>Numbers</source>
        <translation>Zahlen</translation>
    </message>
    <message>
        <source>Show the numbers in a table in place of the plot</source>
        <translation>Die Zahlen in einer Tabelle statt des Diagramms zeigen</translation>
    </message>
    <message>
        <source>Copy as CSV</source>
        <translation>Als CSV kopieren</translation>
    </message>
    <message>
        <source>Put the numbers on the clipboard, a line for each value of the horizontal axis</source>
        <translation>Die Zahlen in die Zwischenablage legen, eine Zeile je Wert der waagrechten Achse</translation>
    </message>
</context>
<context>
    <name>texloom::ui::PortPainting</name>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>There is no picture to paint on yet; open an exemplar, or choose the image first.</source>
        <translation>Es gibt noch kein Bild, auf das gemalt werden kann; öffnen Sie eine Vorlage, oder wählen Sie zuerst das Bild.</translation>
    </message>
    <message>
        <source>There is no exemplar yet whose colours could be painted; open one first.</source>
        <translation>Es gibt noch keine Vorlage, deren Farben gemalt werden könnten; öffnen Sie zuerst eine.</translation>
    </message>
    <message>
        <source>The first colours are those of %1.</source>
        <translation>Die ersten Farben sind die von: %1.</translation>
    </message>
    <message>
        <source>What is there has another size or more than %1 colours, so it is begun anew.</source>
        <translation>Was da ist, hat eine andere Größe oder mehr als %1 Farben, daher wird neu begonnen.</translation>
    </message>
    <message>
        <source>%1 completes no picture; choose a method that does: %2.</source>
        <translation>%1 ergänzt keine Bilder; wählen Sie ein Verfahren, das es tut: %2.</translation>
    </message>
    <message>
        <source>There is no picture to extend yet; open an exemplar, or choose the image first.</source>
        <translation>Es gibt noch kein Bild, das erweitert werden könnte; öffnen Sie eine Vorlage, oder wählen Sie zuerst das Bild.</translation>
    </message>
    <message>
        <source>The picture has %1 px now; press Run to make what lies beyond its edges.</source>
        <translation>Das Bild hat jetzt %1 px; „Ausführen“ macht, was über seine Ränder hinaus liegt.</translation>
    </message>
    <message>
        <source>To make more of the picture beyond its edges, choose “Extend a picture…” from the menu Tools instead.</source>
        <translation>Um das Bild über seine Ränder hinaus fortzusetzen, wählen Sie stattdessen „Ein Bild erweitern …“ im Menü Werkzeuge.</translation>
    </message>
</context>
<context>
    <name>texloom::ui::PortRow</name>
    <message>
        <source>Choose…</source>
        <translation>Wählen …</translation>
    </message>
    <message>
        <source>Choose a file: %1</source>
        <translation>Datei wählen: %1</translation>
    </message>
    <message>
        <source>Take the result that is shown: %1</source>
        <translation>Das gezeigte Ergebnis nehmen: %1</translation>
    </message>
    <message>
        <source>Go without: %1</source>
        <translation>Weglassen: %1</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>Nichts</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Models (%1)</source>
        <translation>Modelle (%1)</translation>
    </message>
    <message>
        <source>Volumes and slices (%1)</source>
        <translation>Volumen und Schnitte (%1)</translation>
    </message>
    <message>
        <source>Meshes (%1)</source>
        <translation>Netze (%1)</translation>
    </message>
    <message>
        <source>Use result</source>
        <translation>Ergebnis verwenden</translation>
    </message>
    <message>
        <source>This result has no position map; choose one whose method copies pixels.</source>
        <translation>Dieses Ergebnis hat keine Positionskarte; wählen Sie eines, dessen Verfahren Pixel kopiert.</translation>
    </message>
    <message>
        <source>This result has no mask; choose one of a method that gives masks.</source>
        <translation>Dieses Ergebnis hat keine Maske; wählen Sie eines von einem Verfahren, das Masken liefert.</translation>
    </message>
    <message>
        <source>This result has no model of the kind %1; choose one of a method that learns such models.</source>
        <translation>Dieses Ergebnis hat kein Modell der Art %1; wählen Sie eines von einem Verfahren, das solche Modelle lernt.</translation>
    </message>
    <message>
        <source>This result has no volume; choose one of a method that gives volumes.</source>
        <translation>Dieses Ergebnis hat kein Volumen; wählen Sie eines von einem Verfahren, das Volumen liefert.</translation>
    </message>
    <message>
        <source>This result has no mesh; choose one of a method that gives meshes.</source>
        <translation>Dieses Ergebnis hat kein Netz; wählen Sie eines von einem Verfahren, das Netze liefert.</translation>
    </message>
    <message>
        <source>This result has no picture; choose another.</source>
        <translation>Dieses Ergebnis hat kein Bild; wählen Sie ein anderes.</translation>
    </message>
    <message>
        <source>Paint the mask: %1…</source>
        <translation>Maske malen: %1 …</translation>
    </message>
    <message>
        <source>There is no result yet that could go in here; press Run first, or choose a file.</source>
        <translation>Noch gibt es kein Ergebnis, das hier hinein könnte; starten Sie zuerst einen Lauf oder wählen Sie eine Datei.</translation>
    </message>
    <message>
        <source>Paint: %1…</source>
        <translation>Malen: %1 …</translation>
    </message>
    <message>
        <source>Extend the picture beyond its edges…</source>
        <translation>Das Bild über seine Ränder hinaus erweitern …</translation>
    </message>
</context>
<context>
    <name>texloom::ui::PresetEditor</name>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopieren</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>&amp;Add a file</source>
        <translation>Datei &amp;hinzufügen</translation>
    </message>
    <message>
        <source>&amp;Remove file</source>
        <translation>Datei &amp;entfernen</translation>
    </message>
    <message>
        <source>Export presets</source>
        <translation>Export-Vorgaben</translation>
    </message>
    <message>
        <source>&amp;Keep</source>
        <translation>&amp;Behalten</translation>
    </message>
    <message>
        <source>A preset of your own that begins as the chosen one is</source>
        <translation>Eine eigene Vorgabe, die wie die gewählte beginnt</translation>
    </message>
    <message>
        <source>The name of the files. $name is the exemplar&apos;s, $map the kind of map; there is $method, $seed, $w, $h, $size and $place, too.</source>
        <translation>Der Name der Dateien. $name ist der der Vorlage, $map die Art der Karte; es gibt auch $method, $seed, $w, $h, $size und $place.</translation>
    </message>
    <message>
        <source>The word that stands for $map in the name of the colours; may be empty</source>
        <translation>Das Wort für $map im Namen der Farben; darf leer sein</translation>
    </message>
    <message>
        <source>As they are</source>
        <translation>Wie sie sind</translation>
    </message>
    <message>
        <source>OpenGL, green up</source>
        <translation>OpenGL, Grün nach oben</translation>
    </message>
    <message>
        <source>DirectX, green down</source>
        <translation>DirectX, Grün nach unten</translation>
    </message>
    <message>
        <source>&amp;Title</source>
        <translation>&amp;Titel</translation>
    </message>
    <message>
        <source>&amp;Names of files</source>
        <translation>Datei&amp;namen</translation>
    </message>
    <message>
        <source>C&amp;olours are called</source>
        <translation>Farben hei&amp;ßen</translation>
    </message>
    <message>
        <source>No&amp;rmals</source>
        <translation>No&amp;rmalen</translation>
    </message>
    <message>
        <source>%1, copy</source>
        <translation>%1, Kopie</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>This one comes with Texloom. Copy it to change it.</source>
        <translation>Diese kommt mit Texloom. Kopieren Sie sie, um sie zu ändern.</translation>
    </message>
    <message>
        <source>New; kept with “Keep”.</source>
        <translation>Neu; wird mit „Behalten“ gesichert.</translation>
    </message>
    <message>
        <source>On the command line: --export-preset %1</source>
        <translation>Auf der Kommandozeile: --export-preset %1</translation>
    </message>
</context>
<context>
    <name>texloom::ui::PresetFilesTable</name>
    <message>
        <source>Smoothness</source>
        <translation>Glätte</translation>
    </message>
    <message>
        <source>Black</source>
        <translation>Schwarz</translation>
    </message>
    <message>
        <source>White</source>
        <translation>Weiß</translation>
    </message>
    <message>
        <source>Files beside the colours</source>
        <translation>Dateien neben den Farben</translation>
    </message>
    <message>
        <source>$map</source>
        <translation>$map</translation>
    </message>
    <message>
        <source>Holds</source>
        <translation>Enthält</translation>
    </message>
    <message>
        <source>Red</source>
        <translation>Rot</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>Grün</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>Blau</translation>
    </message>
    <message>
        <source>Alpha</source>
        <translation>Alpha</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>The word that stands for $map in the file&apos;s name</source>
        <translation>Das Wort für $map im Namen der Datei</translation>
    </message>
    <message>
        <source>What the file holds</source>
        <translation>Was die Datei enthält</translation>
    </message>
    <message>
        <source>Normals</source>
        <translation>Normalen</translation>
    </message>
    <message>
        <source>Several, by channel</source>
        <translation>Mehrere, je Kanal</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Depth of the file</source>
        <translation>Tiefe der Datei</translation>
    </message>
    <message>
        <source>As the map’s</source>
        <translation>Wie die Karte</translation>
    </message>
    <message>
        <source>map</source>
        <translation>karte</translation>
    </message>
</context>
<context>
    <name>texloom::ui::PresetMenu</name>
    <message>
        <source>Pre&amp;sets</source>
        <translation>&amp;Vorgaben</translation>
    </message>
    <message>
        <source>&amp;Keep settings as a preset…</source>
        <translation>Einstellungen als Vorgabe &amp;behalten …</translation>
    </message>
    <message>
        <source>&amp;Import presets…</source>
        <translation>Vorgaben &amp;importieren …</translation>
    </message>
    <message>
        <source>&amp;Export settings as a preset…</source>
        <translation>Einstellungen als Vorgabe e&amp;xportieren …</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>Entfe&amp;rnen</translation>
    </message>
    <message>
        <source>The preset needs a name with a letter or a figure in it.</source>
        <translation>Die Vorgabe braucht einen Namen mit einem Buchstaben oder einer Ziffer.</translation>
    </message>
    <message>
        <source>Kept the preset %1.</source>
        <translation>Vorgabe %1 behalten.</translation>
    </message>
    <message>
        <source>There is a preset %1 already; rename the file or remove the preset first.</source>
        <translation>Eine Vorgabe %1 gibt es schon; benennen Sie die Datei um oder entfernen Sie die Vorgabe zuerst.</translation>
    </message>
    <message>
        <source>Imported the preset %1.</source>
        <translation>Vorgabe %1 importiert.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>The preset %1 could not be removed.</source>
        <translation>Die Vorgabe %1 konnte nicht entfernt werden.</translation>
    </message>
    <message>
        <source>Keep settings as a preset</source>
        <translation>Einstellungen als Vorgabe behalten</translation>
    </message>
    <message>
        <source>Name of the preset</source>
        <translation>Name der Vorgabe</translation>
    </message>
    <message>
        <source>Import presets</source>
        <translation>Vorgaben importieren</translation>
    </message>
    <message>
        <source>Presets (*.json)</source>
        <translation>Vorgaben (*.json)</translation>
    </message>
    <message>
        <source>Export settings as a preset</source>
        <translation>Einstellungen als Vorgabe exportieren</translation>
    </message>
    <message>
        <source>Wrote the preset %1.</source>
        <translation>Die Vorgabe %1 wurde geschrieben.</translation>
    </message>
</context>
<context>
    <name>texloom::ui::ReadingBar</name>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Reading %1…</source>
        <translation>%1 wird gelesen …</translation>
    </message>
    <message>
        <source>Working</source>
        <translation>In Arbeit</translation>
    </message>
    <message>
        <source>Stops; everything stays as it was.</source>
        <translation>Hört auf; alles bleibt, wie es war.</translation>
    </message>
    <message>
        <source>Editing %1…</source>
        <translation>%1 wird bearbeitet …</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 und %2 weitere</translation>
    </message>
</context>
<context>
    <name>texloom::ui::Readout</name>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
</context>
<context>
    <name>texloom::ui::RecoveryCopy</name>
    <message>
        <source>The session could not be kept for recovery, so a crash would lose it; make room or save it elsewhere. %1</source>
        <translation>Die Sitzung konnte nicht zur Wiederherstellung gesichert werden und ginge bei einem Absturz verloren; schaffen Sie Platz oder speichern Sie sie anderswo. %1</translation>
    </message>
</context>
<context>
    <name>texloom::ui::RecoveryDialog</name>
    <message>
        <source>no exemplars</source>
        <translation>keine Vorlagen</translation>
    </message>
    <message>
        <source>Recover a session</source>
        <translation>Sitzung wiederherstellen</translation>
    </message>
    <message>
        <source>Texloom was not closed properly. This session can be recovered.</source>
        <translation>Texloom wurde nicht ordentlich beendet. Diese Sitzung kann wiederhergestellt werden.</translation>
    </message>
    <message>
        <source>Texloom was not closed properly. These sessions can be recovered, the newest first; those that you leave are offered again.</source>
        <translation>Texloom wurde nicht ordentlich beendet. Diese Sitzungen können wiederhergestellt werden, die neueste zuerst; was Sie liegen lassen, wird wieder angeboten.</translation>
    </message>
    <message>
        <source>Sessions</source>
        <translation>Sitzungen</translation>
    </message>
    <message>
        <source>&amp;Recover</source>
        <translation>&amp;Wiederherstellen</translation>
    </message>
    <message>
        <source>&amp;Throw away</source>
        <translation>Ver&amp;werfen</translation>
    </message>
    <message>
        <source>Removes those that are chosen in the list.</source>
        <translation>Entfernt die in der Liste gewählten.</translation>
    </message>
    <message>
        <source>&amp;Later</source>
        <translation>&amp;Später</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>texloom::ui::ResultActions</name>
    <message>
        <source>&amp;Show</source>
        <translation>&amp;Zeigen</translation>
    </message>
    <message>
        <source>Show the chosen result</source>
        <translation>Das gewählte Ergebnis zeigen</translation>
    </message>
    <message>
        <source>&amp;Restore settings</source>
        <translation>Einstellungen &amp;wiederherstellen</translation>
    </message>
    <message>
        <source>Bring the settings of the chosen result back into the form</source>
        <translation>Die Einstellungen des gewählten Ergebnisses ins Formular zurückholen</translation>
    </message>
    <message>
        <source>&amp;Compare</source>
        <translation>&amp;Vergleichen</translation>
    </message>
    <message>
        <source>&amp;Differences…</source>
        <translation>&amp;Unterschiede …</translation>
    </message>
    <message>
        <source>&amp;Pin</source>
        <translation>An&amp;heften</translation>
    </message>
    <message>
        <source>Re&amp;name</source>
        <translation>Umbe&amp;nennen</translation>
    </message>
    <message>
        <source>Give the chosen result a name of your own</source>
        <translation>Dem gewählten Ergebnis einen eigenen Namen geben</translation>
    </message>
    <message>
        <source>De&amp;lete</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>Delete the chosen results</source>
        <translation>Die gewählten Ergebnisse löschen</translation>
    </message>
    <message>
        <source>Look at up to 9 chosen results side by side, with their exemplars</source>
        <translation>Bis zu 9 gewählte Ergebnisse nebeneinander betrachten, mit ihren Vorlagen</translation>
    </message>
    <message>
        <source>List the settings in which two chosen results differ; choose two first</source>
        <translation>Die Einstellungen auflisten, in denen sich zwei gewählte Ergebnisse unterscheiden; wählen Sie zuerst zwei</translation>
    </message>
    <message>
        <source>&amp;Limits…</source>
        <translation>&amp;Grenzen …</translation>
    </message>
    <message>
        <source>Set how much memory and how much of the disk results may take</source>
        <translation>Festlegen, wie viel Arbeitsspeicher und Festplattenplatz Ergebnisse belegen dürfen</translation>
    </message>
    <message>
        <source>&amp;Results</source>
        <translation>&amp;Ergebnisse</translation>
    </message>
    <message>
        <source>Keep the chosen results: pinned ones are never removed automatically</source>
        <translation>Die gewählten Ergebnisse behalten: Angeheftete werden nie von selbst entfernt</translation>
    </message>
    <message>
        <source>&amp;Keep and go on</source>
        <translation>&amp;Behalten und weiter</translation>
    </message>
    <message>
        <source>Pin the chosen result and choose the next one; 1 to 5 give it stars, 0 none</source>
        <translation>Das gewählte Ergebnis anheften und das nächste wählen; 1 bis 5 geben Sterne, 0 keinen</translation>
    </message>
</context>
<context>
    <name>texloom::ui::ResultExport</name>
    <message>
        <source>Writing to %1…</source>
        <translation>Schreibe nach %1 …</translation>
    </message>
    <message>
        <source>Wrote 1 file to %1.</source>
        <translation>1 Datei nach %1 geschrieben.</translation>
    </message>
    <message>
        <source>Wrote %1 files to %2.</source>
        <translation>%1 Dateien nach %2 geschrieben.</translation>
    </message>
    <message>
        <source>Open folder</source>
        <translation>Ordner öffnen</translation>
    </message>
    <message>
        <source>The result is on the clipboard.</source>
        <translation>Das Ergebnis ist in der Zwischenablage.</translation>
    </message>
</context>
<context>
    <name>texloom::ui::ResultHistory</name>
    <message>
        <source>A result stays in memory only and is lost when the window closes: %1</source>
        <translation>Ein Ergebnis bleibt nur im Speicher und geht beim Schließen des Fensters verloren: %1</translation>
    </message>
    <message>
        <source>This result was removed.</source>
        <translation>Dieses Ergebnis wurde entfernt.</translation>
    </message>
    <message>
        <source>The oldest results that are not pinned were removed, %1 in number, to keep the rest within %2.</source>
        <translation>Die ältesten nicht angehefteten Ergebnisse wurden entfernt, %1 an der Zahl, damit der Rest in %2 passt.</translation>
    </message>
    <message>
        <source>pinned</source>
        <translation>angeheftet</translation>
    </message>
    <message>
        <source>shown</source>
        <translation>angezeigt</translation>
    </message>
    <message>
        <source>made before the edit</source>
        <translation>vor der Bearbeitung gemacht</translation>
    </message>
    <message>
        <source>%1 of %2 stars</source>
        <translation>%1 von %2 Sternen</translation>
    </message>
    <message>
        <source>before the edit</source>
        <translation>vor der Bearbeitung</translation>
    </message>
</context>
<context>
    <name>texloom::ui::ResultPanel</name>
    <message>
        <source>Search results</source>
        <translation>Ergebnisse durchsuchen</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>Ergebnisse</translation>
    </message>
    <message>
        <source>“%1” was deleted.</source>
        <translation>„%1“ wurde gelöscht.</translation>
    </message>
    <message>
        <source>%1 results were deleted.</source>
        <translation>%1 Ergebnisse wurden gelöscht.</translation>
    </message>
    <message>
        <source>No result has “%1” in its name, method, exemplar, seed or notes.</source>
        <translation>Kein Ergebnis hat „%1“ in Name, Verfahren, Vorlage, Startwert oder Notizen.</translation>
    </message>
    <message>
        <source>Every run is kept here with its settings. There is none yet: press Run.</source>
        <translation>Jeder Vorgang wird hier mit seinen Einstellungen aufbewahrt. Noch ist keiner da: Drücken Sie „Ausführen“.</translation>
    </message>
    <message>
        <source>%1 in memory, %2 on disk</source>
        <translation>%1 im Speicher, %2 auf dem Datenträger</translation>
    </message>
    <message>
        <source>Up to %1 of results stay in memory and up to %2 on the disk; “Limits…” in the Results menu changes that.</source>
        <translation>Bis zu %1 an Ergebnissen bleiben im Speicher und bis zu %2 auf dem Datenträger; „Grenzen …“ im Menü „Ergebnisse“ ändert das.</translation>
    </message>
    <message>
        <source>Results shown</source>
        <translation>Gezeigte Ergebnisse</translation>
    </message>
    <message>
        <source>Which results are shown; the others stay.</source>
        <translation>Welche Ergebnisse gezeigt werden; die anderen bleiben.</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Alle</translation>
    </message>
    <message>
        <source>Without previews</source>
        <translation>Ohne Vorschauen</translation>
    </message>
    <message>
        <source>Pinned</source>
        <translation>Angeheftet</translation>
    </message>
    <message>
        <source>No result is of the kind chosen above; “All” shows the others.</source>
        <translation>Kein Ergebnis ist von der oben gewählten Art; „Alle“ zeigt die übrigen.</translation>
    </message>
    <message>
        <source>&amp;Pin %1 results</source>
        <translation>%1 Ergebnisse an&amp;heften</translation>
    </message>
    <message>
        <source>&amp;Pin</source>
        <translation>An&amp;heften</translation>
    </message>
    <message>
        <source>Re&amp;name</source>
        <translation>Umbe&amp;nennen</translation>
    </message>
    <message>
        <source>De&amp;lete %1 results</source>
        <translation>%1 Ergebnisse &amp;löschen</translation>
    </message>
    <message>
        <source>De&amp;lete</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>&amp;Pin “%1”</source>
        <translation>„%1“ an&amp;heften</translation>
    </message>
    <message>
        <source>Re&amp;name “%1”</source>
        <translation>„%1“ umbe&amp;nennen</translation>
    </message>
    <message>
        <source>De&amp;lete “%1”</source>
        <translation>„%1“ &amp;löschen</translation>
    </message>
    <message>
        <source>With stars</source>
        <translation>Mit Sternen</translation>
    </message>
    <message>
        <source>Delete pinned results?</source>
        <translation>Angeheftete Ergebnisse löschen?</translation>
    </message>
    <message>
        <source>“%1” is pinned. Delete it all the same?</source>
        <translation>„%1“ ist angeheftet. Trotzdem löschen?</translation>
    </message>
    <message>
        <source>%1 of the %2 chosen results are pinned. Delete all of them?</source>
        <translation>%1 der %2 gewählten Ergebnisse sind angeheftet. Alle löschen?</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Löschen</translation>
    </message>
</context>
<context>
    <name>texloom::ui::ResultView</name>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Synthesis map</source>
        <translation>Synthesekarte</translation>
    </message>
    <message>
        <source>Position map</source>
        <translation>Positionskarte</translation>
    </message>
    <message>
        <source>Every pixel in the colour that the position map gives its source: even areas are copied as they are.</source>
        <translation>Jedes Pixel in der Farbe, die die Positionskarte seiner Quelle gibt: Ebenmäßige Flächen sind so kopiert, wie sie sind.</translation>
    </message>
    <message>
        <source>The legend of the synthesis map: a colour for every pixel of the exemplar.</source>
        <translation>Die Legende der Synthesekarte: eine Farbe für jedes Pixel der Vorlage.</translation>
    </message>
    <message>
        <source>No result yet. Press Run.</source>
        <translation>Noch kein Ergebnis. Drücken Sie „Ausführen“.</translation>
    </message>
    <message>
        <source>Open an exemplar to see its position map.</source>
        <translation>Öffnen Sie eine Vorlage, um ihre Positionskarte zu sehen.</translation>
    </message>
    <message>
        <source>No result yet. The map shows where each of its pixels came from.</source>
        <translation>Noch kein Ergebnis. Die Karte zeigt, woher jedes seiner Pixel kommt.</translation>
    </message>
    <message>
        <source>Exact: every pixel is a copy of the exemplar&apos;s pixel of this colour.</source>
        <translation>Genau: Jedes Pixel ist eine Kopie des Vorlagenpixels dieser Farbe.</translation>
    </message>
    <message>
        <source>Pixels are blends: each has the colour of the source that weighs most.</source>
        <translation>Pixel sind Mischungen: Jedes hat die Farbe der Quelle mit dem größten Gewicht.</translation>
    </message>
    <message>
        <source>Estimated: the place in the exemplar that each new pixel is most like.</source>
        <translation>Geschätzt: die Stelle der Vorlage, der jedes neue Pixel am ähnlichsten ist.</translation>
    </message>
    <message>
        <source>Copied pieces</source>
        <translation>Kopierte Stücke</translation>
    </message>
    <message>
        <source>What was copied in one piece: an even colour for each, with black borders.</source>
        <translation>Was in einem Stück kopiert wurde: je eine gleichmäßige Farbe mit schwarzen Rändern.</translation>
    </message>
    <message>
        <source>The largest piece copied as it is takes %1 of the result.%2</source>
        <translation>Das größte unverändert kopierte Stück nimmt %1 des Ergebnisses ein.%2</translation>
    </message>
    <message>
        <source>This method tells where pixels came from only at its end, or not at all.</source>
        <translation>Dieses Verfahren sagt erst am Ende oder gar nicht, woher Pixel kommen.</translation>
    </message>
    <message>
        <source>Looking at what was copied…</source>
        <translation>Kopiertes wird betrachtet …</translation>
    </message>
    <message>
        <source>Estimated</source>
        <translation>Geschätzt</translation>
    </message>
    <message>
        <source>%1 · estimated</source>
        <translation>%1 · geschätzt</translation>
    </message>
    <message>
        <source>This method makes new pixels and copies none, so there is no map of where they came from. An estimated one shows what in the exemplar each is most like.</source>
        <translation>Dieses Verfahren erzeugt neue Pixel und kopiert keine, also gibt es keine Karte ihrer Herkunft. Eine geschätzte zeigt, wem in der Vorlage jedes am ähnlichsten ist.</translation>
    </message>
    <message>
        <source>This method learned from no exemplar, so there is no map of where its pixels came from.</source>
        <translation>Dieses Verfahren hat von keiner Vorlage gelernt; deshalb gibt es keine Karte der Herkunft seiner Pixel.</translation>
    </message>
    <message>
        <source>Does not wrap: make it wrap</source>
        <translation>Nicht kachelbar: kachelbar machen</translation>
    </message>
    <message>
        <source>Ticks both axes under “Wraps” and runs these settings again.</source>
        <translation>Wählt unter „Kachelbar“ beide Achsen und führt diese Einstellungen neu aus.</translation>
    </message>
    <message>
        <source>Made before the edit: run again</source>
        <translation>Vor der Bearbeitung gemacht: neu ausführen</translation>
    </message>
    <message>
        <source>The exemplar was edited since; runs these settings on it as it is now.</source>
        <translation>Die Vorlage wurde seither bearbeitet; führt diese Einstellungen mit ihr aus, wie sie jetzt ist.</translation>
    </message>
</context>
<context>
    <name>texloom::ui::RunController</name>
    <message>
        <source>%1 · seed %2 · %3</source>
        <translation>%1 · Startwert %2 · %3</translation>
    </message>
    <message>
        <source>Preparing the pictures</source>
        <translation>Bilder werden vorbereitet</translation>
    </message>
    <message>
        <source>The run goes on, but a crash would lose it; make room on the disk. %1</source>
        <translation>Der Vorgang läuft weiter, ginge aber bei einem Absturz verloren; schaffen Sie Platz auf dem Datenträger. %1</translation>
    </message>
    <message>
        <source>Stopping…</source>
        <translation>Wird angehalten …</translation>
    </message>
</context>
<context>
    <name>texloom::ui::RunDesk</name>
    <message>
        <source>Started: %1</source>
        <translation>Begonnen: %1</translation>
    </message>
    <message>
        <source>Failed: %1: %2</source>
        <translation>Fehlgeschlagen: %1: %2</translation>
    </message>
    <message>
        <source>Finished in %1: %2</source>
        <translation>Fertig in %1: %2</translation>
    </message>
    <message>
        <source>Note: %1</source>
        <translation>Hinweis: %1</translation>
    </message>
    <message>
        <source>Cancelled at %1: %2</source>
        <translation>Abgebrochen bei %1: %2</translation>
    </message>
    <message>
        <source>Stopped at %1 and kept, after %2: %3</source>
        <translation>Angehalten bei %1 und behalten, nach %2: %3</translation>
    </message>
</context>
<context>
    <name>texloom::ui::RunDisplay</name>
    <message>
        <source>Quick preview under way: %1</source>
        <translation>Schnellvorschau läuft: %1</translation>
    </message>
    <message>
        <source>Under way: %1</source>
        <translation>Läuft: %1</translation>
    </message>
    <message>
        <source>Quick preview</source>
        <translation>Schnellvorschau</translation>
    </message>
    <message>
        <source>Preview 1:%1</source>
        <translation>Vorschau 1:%1</translation>
    </message>
    <message>
        <source>Quick preview: %1</source>
        <translation>Schnellvorschau: %1</translation>
    </message>
    <message>
        <source>Stopped at %1</source>
        <translation>Angehalten bei %1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Finished: %1.</source>
        <translation>Fertig: %1.</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>There is no picture yet that could be kept; the run ends as soon as there is one.</source>
        <translation>Noch gibt es kein Bild, das behalten werden könnte; der Vorgang endet, sobald eines da ist.</translation>
    </message>
    <message>
        <source>Cancel it now</source>
        <translation>Jetzt abbrechen</translation>
    </message>
    <message>
        <source>Cancelled at %1, and nothing of it kept: %2.</source>
        <translation>Abgebrochen bei %1, nichts davon behalten: %2.</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>The result and its maps lit, on a shape or a mesh of your own.</source>
        <translation>Das Ergebnis und seine Karten im Licht, auf einer Form oder einem eigenen Netz.</translation>
    </message>
    <message>
        <source>Written to %1.</source>
        <translation>Nach %1 geschrieben.</translation>
    </message>
    <message>
        <source>Open folder</source>
        <translation>Ordner öffnen</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>The volume of the result: slices at any place, a block cut open, a mesh.</source>
        <translation>Das Volumen des Ergebnisses: Schnitte an jeder Stelle, ein aufgeschnittener Block, ein Netz.</translation>
    </message>
</context>
<context>
    <name>texloom::ui::RunNotice</name>
    <message>
        <source>Finished</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>Failed</source>
        <translation>Fehlgeschlagen</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>texloom::ui::RunPanel</name>
    <message>
        <source>Progress of the run</source>
        <translation>Fortschritt des Vorgangs</translation>
    </message>
    <message>
        <source>Needs %1 of memory</source>
        <translation>Braucht %1 Speicher</translation>
    </message>
    <message>
        <source>under 1 s</source>
        <translation>unter 1 s</translation>
    </message>
    <message>
        <source>about %1</source>
        <translation>etwa %1</translation>
    </message>
    <message>
        <source>Takes %1 · %2 of memory</source>
        <translation>Dauert %1 · %2 Speicher</translation>
    </message>
    <message>
        <source>Cannot run: %1</source>
        <translation>Geht nicht: %1</translation>
    </message>
    <message>
        <source>%1 waiting</source>
        <translation>%1 wartend</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>%1, %2 left</source>
        <translation>%1, noch %2</translation>
    </message>
</context>
<context>
    <name>texloom::ui::RunRecovery</name>
    <message>
        <source>A run was broken off at %1: %2.</source>
        <translation>Ein Vorgang brach bei %1 ab: %2.</translation>
    </message>
    <message>
        <source>Go on with a run</source>
        <translation>Vorgang fortsetzen</translation>
    </message>
    <message>
        <source>&amp;Go on from %1</source>
        <translation>Ab %1 &amp;fortsetzen</translation>
    </message>
    <message>
        <source>&amp;Restore settings</source>
        <translation>&amp;Einstellungen wiederherstellen</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>Ver&amp;werfen</translation>
    </message>
    <message>
        <source>&amp;Later</source>
        <translation>&amp;Später</translation>
    </message>
</context>
<context>
    <name>texloom::ui::Scope</name>
    <message>
        <source>Histogram, 0 to 255</source>
        <translation>Histogramm, 0 bis 255</translation>
    </message>
    <message>
        <source>Waveform: red, green, blue</source>
        <translation>Wellenform: Rot, Grün, Blau</translation>
    </message>
</context>
<context>
    <name>texloom::ui::ShortcutsDialog</name>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>What they do</source>
        <translation>Was sie tun</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Rad</translation>
    </message>
    <message>
        <source>In a picture: zoom at the cursor</source>
        <translation>Im Bild: am Zeiger zoomen</translation>
    </message>
    <message>
        <source>Drag</source>
        <translation>Ziehen</translation>
    </message>
    <message>
        <source>In a picture: move it</source>
        <translation>Im Bild: es verschieben</translation>
    </message>
    <message>
        <source>Arrow keys</source>
        <translation>Pfeiltasten</translation>
    </message>
    <message>
        <source>Shift+arrow keys</source>
        <translation>Umschalt+Pfeiltasten</translation>
    </message>
    <message>
        <source>In a picture: move from pixel to pixel and show where each came from</source>
        <translation>Im Bild: von Pixel zu Pixel gehen und zeigen, woher jedes kommt</translation>
    </message>
    <message>
        <source>Double click</source>
        <translation>Doppelklick</translation>
    </message>
    <message>
        <source>On a parameter&apos;s label: reset it</source>
        <translation>Auf der Beschriftung eines Parameters: ihn zurücksetzen</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Leertaste</translation>
    </message>
    <message>
        <source>In the lattice: go to the next handle; the arrow keys move it by 1 px, with Shift by 10 px, with Ctrl by 0.1 px</source>
        <translation>Im Gitter: zum nächsten Griff; die Pfeiltasten bewegen ihn um 1 px, mit Umschalt um 10 px, mit Strg um 0,1 px</translation>
    </message>
    <message>
        <source>Return</source>
        <translation>Eingabe</translation>
    </message>
    <message>
        <source>In a comparison: take over the settings of the picture in use</source>
        <translation>Im Vergleich: die Einstellungen des gewählten Bildes übernehmen</translation>
    </message>
    <message>
        <source>Ctrl+arrow keys</source>
        <translation>Strg+Pfeiltasten</translation>
    </message>
    <message>
        <source>In a wipe: move the line</source>
        <translation>Beim Wischen: die Linie verschieben</translation>
    </message>
    <message>
        <source>Ctrl+Shift+arrow keys</source>
        <translation>Strg+Umschalt+Pfeiltasten</translation>
    </message>
    <message>
        <source>In a wipe: turn the line</source>
        <translation>Beim Wischen: die Linie drehen</translation>
    </message>
    <message>
        <source>Shift+R, G, B, A, C</source>
        <translation>Umschalt+R, G, B, A, C</translation>
    </message>
    <message>
        <source>In a comparison: show red, green, blue, alpha, or colour</source>
        <translation>Im Vergleich: Rot, Grün, Blau, Alpha oder Farbe zeigen</translation>
    </message>
    <message>
        <source>&amp;Use these keys</source>
        <translation>Diese Tasten &amp;verwenden</translation>
    </message>
    <message>
        <source>&amp;Back to the original</source>
        <translation>&amp;Ursprüngliche Tasten</translation>
    </message>
    <message>
        <source>New keys</source>
        <translation>Neue Tasten</translation>
    </message>
    <message>
        <source>&amp;New keys</source>
        <translation>&amp;Neue Tasten</translation>
    </message>
    <message>
        <source>%1 is taken by “%2”; give that other keys first.</source>
        <translation>%1 ist schon für „%2“ vergeben; geben Sie dem zuerst andere Tasten.</translation>
    </message>
    <message>
        <source>These keys work only in the place that is named, and cannot be changed.</source>
        <translation>Diese Tasten gehören zu dem Ort, an dem sie wirken, und bleiben, wie sie sind.</translation>
    </message>
</context>
<context>
    <name>texloom::ui::SliceView</name>
    <message>
        <source>Slice square to %1</source>
        <translation>Schnitt senkrecht zu %1</translation>
    </message>
    <message>
        <source>Oblique slice</source>
        <translation>Schräger Schnitt</translation>
    </message>
    <message>
        <source>Oblique · %1°, %2°</source>
        <translation>Schräg · %1°, %2°</translation>
    </message>
    <message>
        <source>There is no volume to look at.</source>
        <translation>Es gibt kein Volumen zu sehen.</translation>
    </message>
    <message>
        <source>Making it…</source>
        <translation>Wird gemacht …</translation>
    </message>
</context>
<context>
    <name>texloom::ui::SolidPanel</name>
    <message>
        <source>Block with a part cut away</source>
        <translation>Block mit einem weggeschnittenen Teil</translation>
    </message>
    <message>
        <source>Drag to turn it, with Ctrl to move the cut, which goes through the crosshair; the wheel comes nearer. Double click gives it all the room.</source>
        <translation>Ziehen dreht ihn, mit Strg verschiebt es den Schnitt, der durch das Fadenkreuz geht; das Rad kommt näher. Ein Doppelklick gibt ihm allen Platz.</translation>
    </message>
    <message>
        <source>Mesh with the volume&apos;s colours</source>
        <translation>Netz mit den Farben des Volumens</translation>
    </message>
    <message>
        <source>Drag to turn it, with Ctrl to move the volume in the mesh; the wheel comes nearer. Double click gives it all the room.</source>
        <translation>Ziehen dreht es, mit Strg verschiebt es das Volumen im Netz; das Rad kommt näher. Ein Doppelklick gibt ihm allen Platz.</translation>
    </message>
    <message>
        <source>Oblique slice</source>
        <translation>Schräger Schnitt</translation>
    </message>
    <message>
        <source>Block</source>
        <translation>Block</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Netz</translation>
    </message>
    <message>
        <source>What the fourth view shows</source>
        <translation>Was die vierte Ansicht zeigt</translation>
    </message>
    <message>
        <source>How far the slice is turned about the picture&apos;s vertical</source>
        <translation>Wie weit der Schnitt um die Senkrechte des Bildes gedreht ist</translation>
    </message>
    <message>
        <source>How far the slice is turned about the picture&apos;s horizontal</source>
        <translation>Wie weit der Schnitt um die Waagrechte des Bildes gekippt ist</translation>
    </message>
    <message>
        <source>Cuts at 45° between x and z</source>
        <translation>Schneidet bei 45° zwischen x und z</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>Tilt</source>
        <translation>Neigung</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>Nichts</translation>
    </message>
    <message>
        <source>Corner</source>
        <translation>Ecke</translation>
    </message>
    <message>
        <source>Beyond x</source>
        <translation>Jenseits x</translation>
    </message>
    <message>
        <source>Above y</source>
        <translation>Über y</translation>
    </message>
    <message>
        <source>Before z</source>
        <translation>Vor z</translation>
    </message>
    <message>
        <source>What is cut away at the crosshair</source>
        <translation>Was am Fadenkreuz weggeschnitten ist</translation>
    </message>
    <message>
        <source>Voxels along the block&apos;s sides</source>
        <translation>Voxel entlang der Seiten des Blocks</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>Ebene</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>Kugel</translation>
    </message>
    <message>
        <source>Cube</source>
        <translation>Würfel</translation>
    </message>
    <message>
        <source>Cylinder</source>
        <translation>Zylinder</translation>
    </message>
    <message>
        <source>From a file…</source>
        <translation>Aus einer Datei …</translation>
    </message>
    <message>
        <source>The surface; it needs no places in a texture</source>
        <translation>Die Fläche; sie braucht keine Orte in einer Textur</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>Voxels along the mesh&apos;s longest side: more of them are smaller</source>
        <translation>Voxel entlang der längsten Seite des Netzes: mehr davon sind kleiner</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Maßstab</translation>
    </message>
    <message>
        <source>How far the volume is turned about x</source>
        <translation>Wie weit das Volumen um x gedreht ist</translation>
    </message>
    <message>
        <source>How far the volume is turned about y</source>
        <translation>Wie weit das Volumen um y gedreht ist</translation>
    </message>
    <message>
        <source>How far the volume is turned about z</source>
        <translation>Wie weit das Volumen um z gedreht ist</translation>
    </message>
    <message>
        <source>Mesh to show the volume on</source>
        <translation>Netz, das das Volumen zeigt</translation>
    </message>
    <message>
        <source>Meshes (*.obj *.ply *.gltf *.glb)</source>
        <translation>Netze (*.obj *.ply *.gltf *.glb)</translation>
    </message>
</context>
<context>
    <name>texloom::ui::SolidView</name>
    <message>
        <source>Drawing…</source>
        <translation>Wird gezeichnet …</translation>
    </message>
    <message>
        <source>There is no volume to look at.</source>
        <translation>Es gibt kein Volumen zu sehen.</translation>
    </message>
</context>
<context>
    <name>texloom::ui::StartPage</name>
    <message>
        <source>Opened last</source>
        <translation>Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>Exemplars to try</source>
        <translation>Vorlagen zum Ausprobieren</translation>
    </message>
    <message>
        <source>Drop a picture of a material here</source>
        <translation>Ziehen Sie das Bild eines Materials hierher</translation>
    </message>
    <message>
        <source>Texloom makes more of it: any size, no visible repeats. A first preview starts by itself.</source>
        <translation>Texloom macht mehr daraus: jede Größe, ohne sichtbare Wiederholung. Eine erste Vorschau beginnt von selbst.</translation>
    </message>
</context>
<context>
    <name>texloom::ui::StepChain</name>
    <message>
        <source>Method that follows</source>
        <translation>Folgendes Verfahren</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>Nichts</translation>
    </message>
    <message>
        <source>Then</source>
        <translation>Dann</translation>
    </message>
    <message>
        <source>A method that starts from the image made so far and works on it, in the same run and with the same seed.</source>
        <translation>Ein Verfahren, das mit dem bisherigen Bild beginnt und daran weiterarbeitet, im selben Vorgang und mit demselben Startwert.</translation>
    </message>
</context>
<context>
    <name>texloom::ui::StressDialog</name>
    <message>
        <source>&amp;Start</source>
        <translation>&amp;Starten</translation>
    </message>
    <message>
        <source>Stress test</source>
        <translation>Belastungsprobe</translation>
    </message>
    <message>
        <source>Rounds</source>
        <translation>Runden</translation>
    </message>
    <message>
        <source>Makes %1 again and again, each time from the texture made before. What a method loses or repeats adds up from round to round.</source>
        <translation>Macht %1 immer wieder neu, jedes Mal aus der Textur davor. Was ein Verfahren verliert oder wiederholt, summiert sich von Runde zu Runde.</translation>
    </message>
    <message>
        <source>&amp;Rounds</source>
        <translation>&amp;Runden</translation>
    </message>
    <message>
        <source>Stopped; the rounds made so far stay.</source>
        <translation>Angehalten; die bisherigen Runden bleiben.</translation>
    </message>
    <message>
        <source>Round %1 of %2…</source>
        <translation>Runde %1 von %2 …</translation>
    </message>
    <message>
        <source>Round %1</source>
        <translation>Runde %1</translation>
    </message>
    <message>
        <source>How far each round is from the exemplar</source>
        <translation>Wie weit jede Runde von der Vorlage entfernt ist</translation>
    </message>
    <message>
        <source>round</source>
        <translation>Runde</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>colours</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>patches, axis 1</source>
        <translation>Patches, Achse 1</translation>
    </message>
    <message>
        <source>patches, axis 2</source>
        <translation>Patches, Achse 2</translation>
    </message>
    <message>
        <source>patches, whole</source>
        <translation>Patches, ganz</translation>
    </message>
    <message>
        <source>patches, half scale</source>
        <translation>Patches, halb so groß</translation>
    </message>
    <message>
        <source>patches, quarter scale</source>
        <translation>Patches, viertel so groß</translation>
    </message>
</context>
<context>
    <name>texloom::ui::SweepDialog</name>
    <message>
        <source>Values across</source>
        <translation>Werte waagrecht</translation>
    </message>
    <message>
        <source>Values down</source>
        <translation>Werte senkrecht</translation>
    </message>
    <message>
        <source>Another seed for &amp;each run</source>
        <translation>Für jeden Vorgang &amp;ein anderer Startwert</translation>
    </message>
    <message>
        <source>At a &amp;preview&apos;s size</source>
        <translation>In &amp;Vorschaugröße</translation>
    </message>
    <message>
        <source>Parameter sweep</source>
        <translation>Parameterreihe</translation>
    </message>
    <message>
        <source>The &amp;same seed for all</source>
        <translation>Der&amp;selbe Startwert für alle</translation>
    </message>
    <message>
        <source>Makes a run for every combination of the values and shows them side by side. Write values as a list (8, 16, 32) or as from:to:count (8:64:5).</source>
        <translation>Macht für jede Kombination der Werte einen Vorgang und zeigt sie nebeneinander. Schreiben Sie Werte als Liste (8, 16, 32) oder als von:bis:Anzahl (8:64:5).</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Beginnen</translation>
    </message>
    <message>
        <source>&amp;Across</source>
        <translation>&amp;Waagrecht</translation>
    </message>
    <message>
        <source>&amp;Down</source>
        <translation>&amp;Senkrecht</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Startwert</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>Nichts</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Whole numbers</source>
        <translation>Ganze Zahlen</translation>
    </message>
    <message>
        <source>1 run</source>
        <translation>1 Vorgang</translation>
    </message>
    <message>
        <source>%1 runs</source>
        <translation>%1 Vorgänge</translation>
    </message>
</context>
<context>
    <name>texloom::ui::TaskBar</name>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
</context>
<context>
    <name>texloom::ui::ToolForm</name>
    <message>
        <source>Show &amp;before</source>
        <translation>&amp;Vorher zeigen</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Anwenden</translation>
    </message>
</context>
<context>
    <name>texloom::ui::Tries</name>
    <message>
        <source>Try &amp;all methods</source>
        <translation>Alle Verfahren aus&amp;probieren</translation>
    </message>
    <message>
        <source>Try &amp;some methods…</source>
        <translation>&amp;Einige Verfahren ausprobieren …</translation>
    </message>
    <message>
        <source>Choose methods, make a run with each and compare them</source>
        <translation>Verfahren wählen, mit jedem einen Lauf machen und sie vergleichen</translation>
    </message>
    <message>
        <source>Parameter s&amp;weep…</source>
        <translation>&amp;Parameterreihe …</translation>
    </message>
    <message>
        <source>Make a run for every combination of some values and compare them</source>
        <translation>Für jede Kombination einiger Werte einen Vorgang machen und sie vergleichen</translation>
    </message>
    <message>
        <source>%1 · seed %2 · %3</source>
        <translation>%1 · Startwert %2 · %3</translation>
    </message>
    <message>
        <source>Make a preview with every method but those of solids, the quickest first, and compare them</source>
        <translation>Mit jedem Verfahren außer denen für Volumen eine Vorschau machen, die schnellsten zuerst, und sie vergleichen</translation>
    </message>
</context>
<context>
    <name>texloom::ui::UndoHistory</name>
    <message>
        <source>Method</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Startwert</translation>
    </message>
    <message>
        <source>Wraps</source>
        <translation>Kachelbar</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>Wiede&amp;rholen</translation>
    </message>
    <message>
        <source>Delete result</source>
        <translation>Ergebnis löschen</translation>
    </message>
    <message>
        <source>Delete results</source>
        <translation>Ergebnisse löschen</translation>
    </message>
    <message>
        <source>Input</source>
        <translation>Eingang</translation>
    </message>
</context>
<context>
    <name>texloom::ui::VarianceDialog</name>
    <message>
        <source>&amp;Compute</source>
        <translation>Be&amp;rechnen</translation>
    </message>
    <message>
        <source>Patch variance</source>
        <translation>Patchvarianz</translation>
    </message>
    <message>
        <source>Sides of the patches in pixels, %1 to %2, with commas between</source>
        <translation>Seiten der Patches in Pixeln, %1 bis %2, mit Kommas dazwischen</translation>
    </message>
    <message>
        <source>How many of the patches most like one, %1 to %2, with commas between</source>
        <translation>Wie viele der ähnlichsten Patches, %1 bis %2, mit Kommas dazwischen</translation>
    </message>
    <message>
        <source>How many patches to take the mean over: more is surer and slower.</source>
        <translation>Über wie viele Patches gemittelt wird: mehr ist sicherer und langsamer.</translation>
    </message>
    <message>
        <source>&amp;Image</source>
        <translation>&amp;Bild</translation>
    </message>
    <message>
        <source>Patch &amp;sizes n</source>
        <translation>Patch&amp;größen n</translation>
    </message>
    <message>
        <source>&amp;Neighbours m</source>
        <translation>&amp;Nachbarn m</translation>
    </message>
    <message>
        <source>&amp;Patches</source>
        <translation>&amp;Patches</translation>
    </message>
    <message>
        <source>Mean standard deviation of the m patches most like one</source>
        <translation>Mittlere Standardabweichung der m ähnlichsten Patches</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>σ̄</source>
        <translation>σ̄</translation>
    </message>
    <message>
        <source>Press Compute. Where σ̄ is small, m patches are alike and a Gaussian model of them copies; where it is large, the model blurs.</source>
        <translation>Drücken Sie „Berechnen“. Wo σ̄ klein ist, sind m Patches ähnlich, und ein Gauß-Modell kopiert sie; wo es groß ist, verwischt das Modell.</translation>
    </message>
    <message>
        <source>Give patch sizes from %1 to %2 px with commas between, such as 10, 20, 40.</source>
        <translation>Geben Sie Patchgrößen von %1 bis %2 px mit Kommas dazwischen an, etwa 10, 20, 40.</translation>
    </message>
    <message>
        <source>Give numbers of neighbours from %1 to %2 with commas between, such as 5, 10, 30.</source>
        <translation>Geben Sie Nachbarzahlen von %1 bis %2 mit Kommas dazwischen an, etwa 5, 10, 30.</translation>
    </message>
    <message>
        <source>The smallest patch of %1 px does not fit into %2 with a shorter side of %3 px.</source>
        <translation>Der kleinste Patch von %1 px passt nicht in %2 mit einer kürzeren Seite von %3 px.</translation>
    </message>
    <message>
        <source>Comparing patches…</source>
        <translation>Patches werden verglichen …</translation>
    </message>
    <message>
        <source>n = %1 px</source>
        <translation>n = %1 px</translation>
    </message>
</context>
<context>
    <name>texloom::ui::VolumePage</name>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>The voxel under the crosshair</source>
        <translation>Das Voxel unter dem Fadenkreuz</translation>
    </message>
    <message>
        <source>All views</source>
        <translation>Alle Ansichten</translation>
    </message>
    <message>
        <source>Gives each view its part of the room again</source>
        <translation>Gibt jeder Ansicht wieder ihren Platz</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Click to bring the crosshair here; drag its lines to move it, and the rest to move along. The wheel zooms, with Ctrl it steps through the volume, like Page Up and Page Down. Double click gives it all the room.</source>
        <translation>Ein Klick bringt das Fadenkreuz hierher; an seinen Linien gezogen bewegt es sich, sonst der Schnitt. Das Rad vergrößert, mit Strg geht es durch das Volumen, wie Bild auf und Bild ab. Ein Doppelklick gibt ihm allen Platz.</translation>
    </message>
    <message>
        <source>Drag to move along, with Shift to turn the slice; a click brings the crosshair here. Double click gives it all the room.</source>
        <translation>Ziehen bewegt den Schnitt, mit Umschalt dreht es ihn; ein Klick bringt das Fadenkreuz hierher. Ein Doppelklick gibt ihm allen Platz.</translation>
    </message>
    <message>
        <source>Slice as it is seen…</source>
        <translation>Schnitt, wie er zu sehen ist …</translation>
    </message>
    <message>
        <source>Box of voxels…</source>
        <translation>Quader aus Voxeln …</translation>
    </message>
    <message>
        <source>Mesh with colours…</source>
        <translation>Netz mit Farben …</translation>
    </message>
    <message>
        <source>Save the slice %1</source>
        <translation>Den Schnitt %1 speichern</translation>
    </message>
    <message>
        <source>Pictures (*.png *.tif *.exr)</source>
        <translation>Bilder (*.png *.tif *.exr)</translation>
    </message>
    <message>
        <source>Save a box of voxels</source>
        <translation>Einen Quader aus Voxeln speichern</translation>
    </message>
    <message>
        <source>Raw numbers and JSON (*.json);;Numbered slices (*.png *.tif *.exr)</source>
        <translation>Rohe Zahlen und JSON (*.json);;Nummerierte Schnitte (*.png *.tif *.exr)</translation>
    </message>
    <message>
        <source>There is no mesh yet: choose one in the fourth view, under Mesh.</source>
        <translation>Es gibt noch kein Netz: wählen Sie eines in der vierten Ansicht, unter Netz.</translation>
    </message>
    <message>
        <source>Mesh with colours</source>
        <translation>Netz mit Farben</translation>
    </message>
    <message>
        <source>Voxels from one vertex to the next, at most (0 leaves the mesh as it is):</source>
        <translation>Voxel von einer Ecke zur nächsten, höchstens (0 lässt das Netz, wie es ist):</translation>
    </message>
    <message>
        <source>Save the mesh with its colours</source>
        <translation>Das Netz mit seinen Farben speichern</translation>
    </message>
    <message>
        <source>Meshes with colours (*.ply *.obj *.glb)</source>
        <translation>Netze mit Farben (*.ply *.obj *.glb)</translation>
    </message>
    <message>
        <source>Writing a slice</source>
        <translation>Ein Schnitt wird geschrieben</translation>
    </message>
    <message>
        <source>Writing a box of voxels</source>
        <translation>Ein Quader aus Voxeln wird geschrieben</translation>
    </message>
    <message>
        <source>Colouring a mesh</source>
        <translation>Ein Netz wird gefärbt</translation>
    </message>
    <message>
        <source>There is no volume to save anything of.</source>
        <translation>Es gibt kein Volumen, von dem etwas zu speichern wäre.</translation>
    </message>
</context>
<context>
    <name>texloom::ui::ZoomBox</name>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Vergrößerung</translation>
    </message>
    <message>
        <source>The picture&apos;s size on the screen: 100 % is one screen pixel for each of its own.</source>
        <translation>Die Größe des Bildes auf dem Bildschirm: 100 % ist ein Bildschirmpixel für jedes seiner eigenen.</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Anpassen</translation>
    </message>
</context>
<context>
    <name>text</name>
    <message>
        <source>%1 × %2</source>
        <translation>%1 × %2</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>stopped at %1</source>
        <translation>angehalten bei %1</translation>
    </message>
</context>
</TS>
