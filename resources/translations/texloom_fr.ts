<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
<context>
    <name>FiguresPanel</name>
    <message>
        <source>Values</source>
        <translation>Valeurs</translation>
    </message>
    <message>
        <source>Red</source>
        <translation>Rouge</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>Vert</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>Bleu</translation>
    </message>
    <message>
        <source>Channel %1</source>
        <translation>Canal %1</translation>
    </message>
</context>
<context>
    <name>MethodChooser</name>
    <message>
        <source>Not part of this build</source>
        <translation>Absent de cette version</translation>
    </message>
</context>
<context>
    <name>background</name>
    <message>
        <source>There is not enough memory for this; close an image or choose a smaller one.</source>
        <translation>La mémoire ne suffit pas ; fermez une image ou choisissez-en une plus petite.</translation>
    </message>
</context>
<context>
    <name>core</name>
    <message>
        <source>A cut keeps every pixel as it is in the exemplar; blending mixes a band along the blocks&apos; edges, as in the source.</source>
        <translation>Une coupe garde chaque pixel tel qu’il est dans l’échantillon ; le fondu mélange une bande le long des blocs, comme dans la source.</translation>
    </message>
    <message>
        <source>A sample</source>
        <translation>Un tirage</translation>
    </message>
    <message>
        <source>A variant of the exemplar itself, or of an initial image: every patch is replaced by a random blend of the exemplar patches most like it. The layout stays.</source>
        <translation>Une variante de l’échantillon lui-même ou d’une image de départ : chaque patch est remplacé par un mélange aléatoire des patchs les plus semblables. La disposition reste.</translation>
    </message>
    <message>
        <source>ACEScg</source>
        <translation>ACEScg</translation>
    </message>
    <message>
        <source>Across channels</source>
        <translation>Entre canaux</translation>
    </message>
    <message>
        <source>Advanced</source>
        <translation>Avancé</translation>
    </message>
    <message>
        <source>Ambient occlusion</source>
        <translation>Occlusion ambiante</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Angle</translation>
    </message>
    <message>
        <source>As given</source>
        <translation>Tel qu’indiqué</translation>
    </message>
    <message>
        <source>As the exemplar&apos;s files</source>
        <translation>Comme les fichiers de l’échantillon</translation>
    </message>
    <message>
        <source>Asymptotic spot noise</source>
        <translation>Bruit spot noise asymptotique</translation>
    </message>
    <message>
        <source>Autocorrelation</source>
        <translation>Autocorrélation</translation>
    </message>
    <message>
        <source>Average</source>
        <translation>Moyenne</translation>
    </message>
    <message>
        <source>Axes that are bent one by one; channels as they are may show false colours.</source>
        <translation>Axes déformés un à un ; avec les canaux tels quels, de fausses couleurs peuvent apparaître.</translation>
    </message>
    <message>
        <source>Bands: orientations</source>
        <translation>Bandes : orientations</translation>
    </message>
    <message>
        <source>Bands: phases across scales</source>
        <translation>Bandes : phases entre échelles</translation>
    </message>
    <message>
        <source>Bends</source>
        <translation>Courbures</translation>
    </message>
    <message>
        <source>Blended band</source>
        <translation>Bande fondue</translation>
    </message>
    <message>
        <source>Blender</source>
        <translation>Blender</translation>
    </message>
    <message>
        <source>Blending</source>
        <translation>Fondu</translation>
    </message>
    <message>
        <source>Block</source>
        <translation>Bloc</translation>
    </message>
    <message>
        <source>Block size</source>
        <translation>Taille des blocs</translation>
    </message>
    <message>
        <source>Border</source>
        <translation>Bord</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>Pinceau</translation>
    </message>
    <message>
        <source>Channels</source>
        <translation>Canaux</translation>
    </message>
    <message>
        <source>Channels that count</source>
        <translation>Canaux pris en compte</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Couleur</translation>
    </message>
    <message>
        <source>Colour axes</source>
        <translation>Axes de couleur</translation>
    </message>
    <message>
        <source>Column of the exemplar at which the tile begins.</source>
        <translation>Colonne de l’échantillon où commence la tuile.</translation>
    </message>
    <message>
        <source>Column of the exemplar&apos;s lattice that lies at the output&apos;s left side: moves the pattern sideways.</source>
        <translation>Colonne du réseau de l’échantillon placée au bord gauche de la sortie : décale le motif latéralement.</translation>
    </message>
    <message>
        <source>Compared border</source>
        <translation>Bord comparé</translation>
    </message>
    <message>
        <source>Conditional Gaussian</source>
        <translation>Gaussien conditionnel</translation>
    </message>
    <message>
        <source>Correlation</source>
        <translation>Corrélation</translation>
    </message>
    <message>
        <source>Cosine</source>
        <translation>Cosinus</translation>
    </message>
    <message>
        <source>Data (never converted)</source>
        <translation>Données (jamais converties)</translation>
    </message>
    <message>
        <source>Differences keep brightness even between blocks; correlation fits edges better where brightness differs.</source>
        <translation>Les différences gardent une luminosité égale entre blocs ; la corrélation ajuste mieux les contours où elle varie.</translation>
    </message>
    <message>
        <source>Directions told apart at each scale: more keep lines at more angles, and take longer.</source>
        <translation>Directions distinguées à chaque échelle : davantage conserve plus d’angles et prend plus de temps.</translation>
    </message>
    <message>
        <source>Drawing phases</source>
        <translation>Tirage des phases</translation>
    </message>
    <message>
        <source>Edits of exemplars</source>
        <translation>Retouches des échantillons</translation>
    </message>
    <message>
        <source>Estimating the synthesis map</source>
        <translation>Estimation de la carte de synthèse</translation>
    </message>
    <message>
        <source>Even out the light</source>
        <translation>Égaliser la lumière</translation>
    </message>
    <message>
        <source>Exemplar</source>
        <translation>Échantillon</translation>
    </message>
    <message>
        <source>Exemplars</source>
        <translation>Échantillons</translation>
    </message>
    <message>
        <source>Fading border</source>
        <translation>Bord estompé</translation>
    </message>
    <message>
        <source>Filling gaps</source>
        <translation>Remplissage des vides</translation>
    </message>
    <message>
        <source>Filtering</source>
        <translation>Filtrage</translation>
    </message>
    <message>
        <source>Finds the lattice of a regular texture and repeats the one tile that joins itself best: strictly regular, without the variety of near-regular synthesis.</source>
        <translation>Trouve le réseau d’une texture régulière et répète la tuile qui se raccorde le mieux à elle-même : strictement régulier, sans la variété de la synthèse quasi régulière.</translation>
    </message>
    <message>
        <source>Finds the lattice of bricks, tiles or weave and samples blocks at random along it, then fills the gaps with patches that fit: keeps the courses and varies what lies in them.</source>
        <translation>Trouve le réseau de briques, de carreaux ou d’un tissage, y tire des blocs au hasard et comble les vides par des patchs adaptés : garde les rangées et varie leur contenu.</translation>
    </message>
    <message>
        <source>First vector, down</source>
        <translation>Premier vecteur, vers le bas</translation>
    </message>
    <message>
        <source>First vector, right</source>
        <translation>Premier vecteur, vers la droite</translation>
    </message>
    <message>
        <source>Fit by</source>
        <translation>Ajuster selon</translation>
    </message>
    <message>
        <source>Found by itself</source>
        <translation>Trouvé automatiquement</translation>
    </message>
    <message>
        <source>Gaps filled</source>
        <translation>Vides comblés</translation>
    </message>
    <message>
        <source>Gaussian patches</source>
        <translation>Patchs gaussiens</translation>
    </message>
    <message>
        <source>Gives noise the exemplar&apos;s histogram in every band of a steerable pyramid. Quick and free of copies; suits grainy and stochastic textures, and loses structure.</source>
        <translation>Donne à un bruit l’histogramme de l’échantillon dans chaque bande d’une pyramide orientable. Rapide et sans copie ; convient aux textures granuleuses et stochastiques, perd les structures.</translation>
    </message>
    <message>
        <source>Gives noise the exemplar&apos;s joint statistics in a complex steerable pyramid, round after round. Never copies; suits gravel, grass, bark and other dense textures, and loses regular layouts.</source>
        <translation>Donne à un bruit, tour après tour, les statistiques conjointes de l’échantillon dans une pyramide orientable complexe. Ne copie jamais ; convient au gravier, à l’herbe, à l’écorce et autres textures denses, perd les dispositions régulières.</translation>
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
        <translation>Hauteur</translation>
    </message>
    <message>
        <source>How a patch joins its neighbours: along the cut of least error, or blended over the overlap.</source>
        <translation>Comment un patch rejoint ses voisins : le long de la coupe d’erreur minimale, ou fondu sur le recouvrement.</translation>
    </message>
    <message>
        <source>How far down the texture repeats itself first.</source>
        <translation>À quelle distance vers le bas la texture se répète d’abord.</translation>
    </message>
    <message>
        <source>How far down the texture repeats itself in the other direction.</source>
        <translation>À quelle distance vers le bas la texture se répète dans l’autre direction.</translation>
    </message>
    <message>
        <source>How far from the lattice a patch that fills a gap may lie: more joins better where the texture is irregular, less keeps the courses straight.</source>
        <translation>Écart permis au réseau pour un patch qui comble un vide : plus raccorde mieux une texture irrégulière, moins garde les rangées droites.</translation>
    </message>
    <message>
        <source>How far shared pixels may vary, in per cent of the exemplar&apos;s standard deviation.</source>
        <translation>Variation permise des pixels partagés, en pour cent de l’écart type de l’échantillon.</translation>
    </message>
    <message>
        <source>How far the smoothed cut blends to either side.</source>
        <translation>Étendue du fondu de part et d’autre de la coupe adoucie.</translation>
    </message>
    <message>
        <source>How far to the right the texture repeats itself first.</source>
        <translation>À quelle distance vers la droite la texture se répète d’abord.</translation>
    </message>
    <message>
        <source>How far to the right the texture repeats itself in the other direction.</source>
        <translation>À quelle distance vers la droite la texture se répète dans l’autre direction.</translation>
    </message>
    <message>
        <source>How many of the first channels are synthesised jointly, 0 for all; the others follow them point by point and have no say.</source>
        <translation>Combien des premiers canaux sont synthétisés ensemble, 0 pour tous ; les autres les suivent point par point sans compter.</translation>
    </message>
    <message>
        <source>How much worse than the best a patch may fit and still be drawn: larger varies more, smaller copies longer stretches.</source>
        <translation>De combien un patch peut convenir moins bien que le meilleur et être tiré quand même : plus varie davantage, moins copie de plus longs passages.</translation>
    </message>
    <message>
        <source>How much worse than the best a patch may fit and still be drawn: larger varies more.</source>
        <translation>De combien un patch peut convenir moins bien que le meilleur et être tiré quand même : plus varie davantage.</translation>
    </message>
    <message>
        <source>How often the exemplar is halved, plus one: more keep larger structures.</source>
        <translation>Nombre de réductions de moitié de l’échantillon, plus une : davantage garde de plus grandes structures.</translation>
    </message>
    <message>
        <source>How phases line up from one scale to the next: lit edges against shaded ones.</source>
        <translation>Alignement des phases d’une échelle à l’autre : contours éclairés contre contours ombrés.</translation>
    </message>
    <message>
        <source>How pixels and blurred images repeat within the neighbourhood.</source>
        <translation>Comment pixels et images floutées se répètent dans le voisinage.</translation>
    </message>
    <message>
        <source>How strong lines of one angle and size come in groups.</source>
        <translation>À quel point les lignes d’un angle et d’une taille se groupent.</translation>
    </message>
    <message>
        <source>How the bands of one scale go together in sign, across angles and channels.</source>
        <translation>Accord des signes entre bandes d’une échelle, selon angles et canaux.</translation>
    </message>
    <message>
        <source>Image quilting</source>
        <translation>Quilting d’images</translation>
    </message>
    <message>
        <source>Imposing statistics</source>
        <translation>Imposition des statistiques</translation>
    </message>
    <message>
        <source>Innovation</source>
        <translation>Innovation</translation>
    </message>
    <message>
        <source>Innovation, estimated</source>
        <translation>Innovation, estimée</translation>
    </message>
    <message>
        <source>Iterations</source>
        <translation>Itérations</translation>
    </message>
    <message>
        <source>Join</source>
        <translation>Jonction</translation>
    </message>
    <message>
        <source>Kept (CLG)</source>
        <translation>Conservés (CLG)</translation>
    </message>
    <message>
        <source>Lattice</source>
        <translation>Réseau</translation>
    </message>
    <message>
        <source>Lattice, first vector down</source>
        <translation>Réseau, premier vecteur vers le bas</translation>
    </message>
    <message>
        <source>Lattice, first vector right</source>
        <translation>Réseau, premier vecteur vers la droite</translation>
    </message>
    <message>
        <source>Lattice, second vector down</source>
        <translation>Réseau, second vecteur vers le bas</translation>
    </message>
    <message>
        <source>Lattice, second vector right</source>
        <translation>Réseau, second vecteur vers la droite</translation>
    </message>
    <message>
        <source>Lays out large structures at a coarse scale and adds new detail at each finer one. Keeps the layout of macro-textures with small patches; softer than quilting.</source>
        <translation>Dispose les grandes structures à une échelle grossière et ajoute des détails neufs à chaque échelle plus fine. Garde la disposition des macro-textures avec de petits patchs ; plus doux que le quilting.</translation>
    </message>
    <message>
        <source>Learns from the exemplar&apos;s periodic component, without which its borders count as horizontal and vertical lines.</source>
        <translation>Apprend de la composante périodique de l’échantillon ; sans elle, ses bords comptent comme des lignes horizontales et verticales.</translation>
    </message>
    <message>
        <source>Learns from the exemplar&apos;s periodic component, without which its borders draw horizontal and vertical streaks.</source>
        <translation>Apprend de la composante périodique de l’échantillon ; sans elle, ses bords tracent des traînées horizontales et verticales.</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Lumière</translation>
    </message>
    <message>
        <source>Like quilting, but every patch is new: a random blend of the exemplar patches that fit best. Innovates where quilting copies; a little softer.</source>
        <translation>Comme le quilting, mais chaque patch est neuf : un mélange aléatoire des patchs qui conviennent le mieux. Innove là où le quilting copie ; un peu plus doux.</translation>
    </message>
    <message>
        <source>Linear</source>
        <translation>Linéaire</translation>
    </message>
    <message>
        <source>Linear Rec.709</source>
        <translation>Rec.709 linéaire</translation>
    </message>
    <message>
        <source>Linear blending</source>
        <translation>Fondu linéaire</translation>
    </message>
    <message>
        <source>Locally Gaussian</source>
        <translation>Localement gaussien</translation>
    </message>
    <message>
        <source>Locally Gaussian + Portilla–Simoncelli</source>
        <translation>Localement gaussien + Portilla–Simoncelli</translation>
    </message>
    <message>
        <source>Locally Gaussian + Quilting</source>
        <translation>Localement gaussien + quilting</translation>
    </message>
    <message>
        <source>Looking for the lattice</source>
        <translation>Recherche du réseau</translation>
    </message>
    <message>
        <source>Looking for the tile</source>
        <translation>Recherche de la tuile</translation>
    </message>
    <message>
        <source>Magnitudes: autocorrelation</source>
        <translation>Modules : autocorrélation</translation>
    </message>
    <message>
        <source>Magnitudes: orientations</source>
        <translation>Modules : orientations</translation>
    </message>
    <message>
        <source>Magnitudes: scales</source>
        <translation>Modules : échelles</translation>
    </message>
    <message>
        <source>Marginals</source>
        <translation>Marginales</translation>
    </message>
    <message>
        <source>Matching histograms</source>
        <translation>Ajustement des histogrammes</translation>
    </message>
    <message>
        <source>Mean error along a cut</source>
        <translation>Erreur moyenne le long d’une coupe</translation>
    </message>
    <message>
        <source>Mean squared difference where tiles join</source>
        <translation>Écart quadratique moyen aux jonctions des tuiles</translation>
    </message>
    <message>
        <source>Mean, variance, skewness, kurtosis and range of the pixels and of blurred images.</source>
        <translation>Moyenne, variance, asymétrie, aplatissement et étendue des pixels et d’images floutées.</translation>
    </message>
    <message>
        <source>Measuring the exemplar</source>
        <translation>Mesure de l’échantillon</translation>
    </message>
    <message>
        <source>Measuring the result</source>
        <translation>Mesure du résultat</translation>
    </message>
    <message>
        <source>Metallic</source>
        <translation>Métallique</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Méthode</translation>
    </message>
    <message>
        <source>Midway</source>
        <translation>Midway</translation>
    </message>
    <message>
        <source>Midway quilting</source>
        <translation>Quilting midway</translation>
    </message>
    <message>
        <source>Minimum-error cut</source>
        <translation>Coupe d’erreur minimale</translation>
    </message>
    <message>
        <source>Mismatch of the pixels&apos; histogram</source>
        <translation>Écart de l’histogramme des pixels</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modèle</translation>
    </message>
    <message>
        <source>Momentum</source>
        <translation>Élan</translation>
    </message>
    <message>
        <source>Multiscale Gaussian</source>
        <translation>Gaussien multi-échelle</translation>
    </message>
    <message>
        <source>Multiscale Gaussian + Portilla–Simoncelli</source>
        <translation>Gaussien multi-échelle + Portilla–Simoncelli</translation>
    </message>
    <message>
        <source>Near-regular texture</source>
        <translation>Texture quasi régulière</translation>
    </message>
    <message>
        <source>Neighbourhood</source>
        <translation>Voisinage</translation>
    </message>
    <message>
        <source>Neighbours</source>
        <translation>Voisins</translation>
    </message>
    <message>
        <source>New patches from the locally Gaussian model, then pieces of the exemplar quilted over them: keeps the model&apos;s variety and gets the exemplar&apos;s sharpness back.</source>
        <translation>Des patchs neufs du modèle localement gaussien, puis des morceaux de l’échantillon cousus par-dessus : garde la variété du modèle et retrouve la netteté de l’échantillon.</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Aucun</translation>
    </message>
    <message>
        <source>Normal, green down (DirectX)</source>
        <translation>Normales, vert vers le bas (DirectX)</translation>
    </message>
    <message>
        <source>Normal, green up (OpenGL)</source>
        <translation>Normales, vert vers le haut (OpenGL)</translation>
    </message>
    <message>
        <source>Octaves that the pyramid takes apart: more keep larger features. Small images use fewer.</source>
        <translation>Octaves séparées par la pyramide : davantage garde de plus grands motifs. Les petites images en utilisent moins.</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Opacité</translation>
    </message>
    <message>
        <source>Orientations</source>
        <translation>Orientations</translation>
    </message>
    <message>
        <source>Origin, down</source>
        <translation>Origine, vers le bas</translation>
    </message>
    <message>
        <source>Origin, right</source>
        <translation>Origine, vers la droite</translation>
    </message>
    <message>
        <source>Other data</source>
        <translation>Autres données</translation>
    </message>
    <message>
        <source>Overlap</source>
        <translation>Recouvrement</translation>
    </message>
    <message>
        <source>Overlap values</source>
        <translation>Valeurs du recouvrement</translation>
    </message>
    <message>
        <source>Patch drawn</source>
        <translation>Patch tiré</translation>
    </message>
    <message>
        <source>Patch size</source>
        <translation>Taille du patch</translation>
    </message>
    <message>
        <source>Patches</source>
        <translation>Patchs</translation>
    </message>
    <message>
        <source>Pixels shared with neighbours stay as they are, or vary a little before the rest is drawn.</source>
        <translation>Les pixels partagés avec les voisins restent tels quels, ou varient un peu avant le tirage du reste.</translation>
    </message>
    <message>
        <source>Placing patches</source>
        <translation>Placement des patchs</translation>
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
        <translation>Préparation de l’échantillon</translation>
    </message>
    <message>
        <source>Principal axes</source>
        <translation>Axes principaux</translation>
    </message>
    <message>
        <source>Progressive</source>
        <translation>Progressif</translation>
    </message>
    <message>
        <source>Propagation</source>
        <translation>Propagation</translation>
    </message>
    <message>
        <source>Quilting that bends patches to meet instead of cutting them: structures such as stripes are drawn together along the overlap.</source>
        <translation>Un quilting qui courbe les patchs l’un vers l’autre au lieu de les couper : les structures comme les rayures se rejoignent sur le recouvrement.</translation>
    </message>
    <message>
        <source>Random phase</source>
        <translation>Phase aléatoire</translation>
    </message>
    <message>
        <source>Random phase noise</source>
        <translation>Bruit à phase aléatoire</translation>
    </message>
    <message>
        <source>Random phase noise keeps each frequency&apos;s strength exactly; spot noise lets it vary as in a Gaussian field.</source>
        <translation>Le bruit à phase aléatoire garde exactement la force de chaque fréquence ; le spot noise la laisse varier comme dans un champ gaussien.</translation>
    </message>
    <message>
        <source>Regular tile</source>
        <translation>Tuile régulière</translation>
    </message>
    <message>
        <source>Regularisation</source>
        <translation>Régularisation</translation>
    </message>
    <message>
        <source>Relaxation</source>
        <translation>Relâchement</translation>
    </message>
    <message>
        <source>Relaxed (RCLG)</source>
        <translation>Relâchés (RCLG)</translation>
    </message>
    <message>
        <source>Repeating the tile</source>
        <translation>Répétition de la tuile</translation>
    </message>
    <message>
        <source>Replacing patches</source>
        <translation>Remplacement des patchs</translation>
    </message>
    <message>
        <source>Roughness</source>
        <translation>Rugosité</translation>
    </message>
    <message>
        <source>Rounds between pyramid and pixels: more bring both closer to the exemplar.</source>
        <translation>Allers-retours entre pyramide et pixels : davantage rapproche les deux de l’échantillon.</translation>
    </message>
    <message>
        <source>Rounds over all statistics: more bring them closer to the exemplar&apos;s.</source>
        <translation>Passes sur toutes les statistiques : davantage les rapproche de celles de l’échantillon.</translation>
    </message>
    <message>
        <source>Row of the exemplar at which the tile begins.</source>
        <translation>Ligne de l’échantillon où commence la tuile.</translation>
    </message>
    <message>
        <source>Row of the exemplar&apos;s lattice that lies at the output&apos;s top: moves the pattern up or down.</source>
        <translation>Ligne du réseau de l’échantillon placée en haut de la sortie : décale le motif vers le haut ou le bas.</translation>
    </message>
    <message>
        <source>Sampling blocks</source>
        <translation>Tirage des blocs</translation>
    </message>
    <message>
        <source>Sampling patches</source>
        <translation>Tirage des patchs</translation>
    </message>
    <message>
        <source>Sampling scale {} of {}</source>
        <translation>Tirage de l’échelle {} sur {}</translation>
    </message>
    <message>
        <source>Scales</source>
        <translation>Échelles</translation>
    </message>
    <message>
        <source>Scales used</source>
        <translation>Échelles utilisées</translation>
    </message>
    <message>
        <source>Seam, left to right</source>
        <translation>Couture, gauche/droite</translation>
    </message>
    <message>
        <source>Seam, top to bottom</source>
        <translation>Couture, haut/bas</translation>
    </message>
    <message>
        <source>Second vector, down</source>
        <translation>Second vecteur, vers le bas</translation>
    </message>
    <message>
        <source>Second vector, right</source>
        <translation>Second vecteur, vers la droite</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Graine</translation>
    </message>
    <message>
        <source>Sews square patches of the exemplar together along the cuts where they differ least. Fast and faithful to structure such as bricks or leaves; copies larger areas verbatim.</source>
        <translation>Coud des patchs carrés de l’échantillon le long des coupes où ils diffèrent le moins. Rapide et fidèle aux structures comme les briques ou les feuilles ; copie de grandes zones telles quelles.</translation>
    </message>
    <message>
        <source>Share of each round&apos;s change that is added once more: some brings the statistics closer in fewer rounds.</source>
        <translation>Part de la modification de chaque passe ajoutée une fois de plus : un peu rapproche les statistiques en moins de passes.</translation>
    </message>
    <message>
        <source>Share of each side over which the exemplar fades out where the output has another size: larger leaves fewer streaks, smaller keeps slow changes.</source>
        <translation>Part de chaque côté où l’échantillon s’estompe quand la sortie a une autre taille : plus laisse moins de traînées, moins garde les variations lentes.</translation>
    </message>
    <message>
        <source>Share of the patch over which it fades into its neighbours.</source>
        <translation>Part du patch où il se fond dans ses voisins.</translation>
    </message>
    <message>
        <source>Share of the patch that is given by its neighbours: larger fits better and takes longer.</source>
        <translation>Part du patch donnée par ses voisins : plus convient mieux et prend plus de temps.</translation>
    </message>
    <message>
        <source>Share of the patch that overlaps its neighbours: larger bends more gently.</source>
        <translation>Part du patch qui recouvre ses voisins : plus courbe plus doucement.</translation>
    </message>
    <message>
        <source>Share of the patch that overlaps its neighbours: larger fits better and takes longer.</source>
        <translation>Part du patch qui recouvre ses voisins : plus convient mieux et prend plus de temps.</translation>
    </message>
    <message>
        <source>Share of the patch that overlaps its neighbours: larger joins better, but repeats itself sooner.</source>
        <translation>Part du patch qui recouvre ses voisins : plus raccorde mieux, mais se répète plus tôt.</translation>
    </message>
    <message>
        <source>Side of the patches at every scale: at the coarsest one they cover 2 to the power of scales − 1 times as much.</source>
        <translation>Côté des patchs à chaque échelle : à la plus grossière, ils couvrent 2 puissance (échelles − 1) fois plus.</translation>
    </message>
    <message>
        <source>Side of the patches that are replaced: larger changes larger parts at once.</source>
        <translation>Côté des patchs remplacés : plus change de plus grandes parties à la fois.</translation>
    </message>
    <message>
        <source>Side of the patches: larger keeps larger structures whole, smaller finds more that are alike.</source>
        <translation>Côté des patchs : plus garde entières de plus grandes structures, moins en trouve davantage de semblables.</translation>
    </message>
    <message>
        <source>Side of the square in which pixels and magnitudes are compared at each scale: larger keeps larger patterns, but copies chance ones.</source>
        <translation>Côté du carré où pixels et modules sont comparés à chaque échelle : plus garde de plus grands motifs, mais copie ceux du hasard.</translation>
    </message>
    <message>
        <source>Side of the squares that are copied: larger keeps larger structures whole, smaller varies more.</source>
        <translation>Côté des carrés copiés : plus garde entières de plus grandes structures, moins varie davantage.</translation>
    </message>
    <message>
        <source>Similar patches that a Gaussian is learnt from: more join more smoothly and blur more.</source>
        <translation>Patchs semblables dont une gaussienne est apprise : davantage se joint mieux et floute plus.</translation>
    </message>
    <message>
        <source>Similar patches that each new one is blended from: more vary more and blur more.</source>
        <translation>Patchs semblables dont chaque nouveau est mélangé : davantage varie et floute plus.</translation>
    </message>
    <message>
        <source>Similar patches that each new one is blended from: more vary more and blur more; 1 copies.</source>
        <translation>Patchs semblables dont chaque nouveau est mélangé : davantage varie et floute plus ; 1 copie.</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>Smoothed cut</source>
        <translation>Coupe adoucie</translation>
    </message>
    <message>
        <source>Soft changes</source>
        <translation>Variations douces</translation>
    </message>
    <message>
        <source>Softness</source>
        <translation>Douceur</translation>
    </message>
    <message>
        <source>Squared differences</source>
        <translation>Différences au carré</translation>
    </message>
    <message>
        <source>Start from</source>
        <translation>Partir de</translation>
    </message>
    <message>
        <source>Starting</source>
        <translation>Démarrage</translation>
    </message>
    <message>
        <source>Statistics</source>
        <translation>Statistiques</translation>
    </message>
    <message>
        <source>Stitch</source>
        <translation>Couture</translation>
    </message>
    <message>
        <source>Straighten</source>
        <translation>Redresser</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Force</translation>
    </message>
    <message>
        <source>Take off border jumps</source>
        <translation>Ôter les sauts aux bords</translation>
    </message>
    <message>
        <source>Takes slow changes of brightness out of the exemplar first, so that blocks from its light and dark parts match; pixels change a little.</source>
        <translation>Ôte d’abord les lentes variations de luminosité de l’échantillon, pour que les blocs de ses parties claires et sombres s’accordent ; les pixels changent un peu.</translation>
    </message>
    <message>
        <source>The large structures of the multiscale Gaussian model, sharpened by Portilla–Simoncelli.</source>
        <translation>Les grandes structures du modèle gaussien multi-échelle, affinées par Portilla–Simoncelli.</translation>
    </message>
    <message>
        <source>The layout of the locally Gaussian model with the grain of Portilla–Simoncelli: nothing is copied, and where the model went astray it is drawn back.</source>
        <translation>La disposition du modèle localement gaussien avec le grain de Portilla–Simoncelli : rien n’est copié, et là où le modèle s’égare il est ramené.</translation>
    </message>
    <message>
        <source>The most probable</source>
        <translation>Le plus probable</translation>
    </message>
    <message>
        <source>The most probable patch joins most smoothly and loses detail; samples differ each time.</source>
        <translation>Le patch le plus probable se joint le mieux et perd des détails ; les tirages diffèrent à chaque fois.</translation>
    </message>
    <message>
        <source>The one that joins itself best</source>
        <translation>Celle qui se raccorde le mieux</translation>
    </message>
    <message>
        <source>The tile that is repeated: the one whose opposite sides are most alike, or the one at a given place.</source>
        <translation>La tuile répétée : celle dont les côtés opposés se ressemblent le plus, ou celle d’un endroit donné.</translation>
    </message>
    <message>
        <source>The two vectors by which the texture repeats itself: found in the exemplar, given, or none for a texture that does not repeat.</source>
        <translation>Les deux vecteurs selon lesquels la texture se répète : trouvés dans l’échantillon, donnés, ou aucun pour une texture qui ne se répète pas.</translation>
    </message>
    <message>
        <source>Then</source>
        <translation>Puis</translation>
    </message>
    <message>
        <source>Tile</source>
        <translation>Tuile</translation>
    </message>
    <message>
        <source>Tile&apos;s corner, down</source>
        <translation>Coin de la tuile, vers le bas</translation>
    </message>
    <message>
        <source>Tile&apos;s corner, right</source>
        <translation>Coin de la tuile, vers la droite</translation>
    </message>
    <message>
        <source>Tile, first vector down</source>
        <translation>Tuile, premier vecteur vers le bas</translation>
    </message>
    <message>
        <source>Tile, first vector right</source>
        <translation>Tuile, premier vecteur vers la droite</translation>
    </message>
    <message>
        <source>Tile, second vector down</source>
        <translation>Tuile, second vecteur vers le bas</translation>
    </message>
    <message>
        <source>Tile, second vector right</source>
        <translation>Tuile, second vecteur vers la droite</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolérance</translation>
    </message>
    <message>
        <source>Turns and shears the exemplar so that its courses run along the axes in whole pixels; pixels are interpolated.</source>
        <translation>Tourne et cisaille l’échantillon pour que ses rangées suivent les axes en pixels entiers ; les pixels sont interpolés.</translation>
    </message>
    <message>
        <source>Unity (mask map)</source>
        <translation>Unity (mask map)</translation>
    </message>
    <message>
        <source>Unreal Engine</source>
        <translation>Unreal Engine</translation>
    </message>
    <message>
        <source>Weight of the second exemplar</source>
        <translation>Poids du second échantillon</translation>
    </message>
    <message>
        <source>Whether channels are synthesised jointly; without, each principal component is by itself.</source>
        <translation>Si les canaux sont synthétisés ensemble ; sinon chaque composante principale est seule.</translation>
    </message>
    <message>
        <source>Whether the bending fades out over the overlap, or lines pass into each other.</source>
        <translation>Si la courbure s’estompe sur le recouvrement, ou si les lignes passent l’une dans l’autre.</translation>
    </message>
    <message>
        <source>Which angles come together: corners and crossings.</source>
        <translation>Quels angles vont ensemble : coins et croisements.</translation>
    </message>
    <message>
        <source>Which sizes come together: edges against thin lines.</source>
        <translation>Quelles tailles vont ensemble : contours contre lignes fines.</translation>
    </message>
    <message>
        <source>White noise added to the model, in per cent of the exemplar&apos;s standard deviation: more lets patches fit their neighbours less.</source>
        <translation>Bruit blanc ajouté au modèle, en pour cent de l’écart type de l’échantillon : plus laisse les patchs moins s’accorder à leurs voisins.</translation>
    </message>
    <message>
        <source>Width in which a patch is compared with, and joined to, its neighbours; 0 takes a share of the block.</source>
        <translation>Largeur où un patch est comparé et joint à ses voisins ; 0 prend une part du bloc.</translation>
    </message>
    <message>
        <source>Width of the band that is blended: wider hides differences of brightness between blocks, narrower is sharper.</source>
        <translation>Largeur de la bande fondue : plus large cache les écarts de luminosité entre blocs, plus étroite est plus nette.</translation>
    </message>
    <message>
        <source>Width of the borders in which opposite sides of a tile are compared: wider looks for tiles that join in larger structures.</source>
        <translation>Largeur des bords où les côtés opposés d’une tuile sont comparés : plus large cherche des tuiles qui se raccordent dans de plus grandes structures.</translation>
    </message>
    <message>
        <source>Wraps</source>
        <translation>Raccord</translation>
    </message>
    <message>
        <source>glTF</source>
        <translation>glTF</translation>
    </message>
    <message>
        <source>packed companion maps</source>
        <translation>cartes associées groupées</translation>
    </message>
    <message>
        <source>sRGB</source>
        <translation>sRGB</translation>
    </message>
    <message>
        <source>Comparing colours</source>
        <translation>Comparaison des couleurs</translation>
    </message>
    <message>
        <source>Comparing patches</source>
        <translation>Comparaison des patchs</translation>
    </message>
    <message>
        <source>Comparing with itself</source>
        <translation>Comparaison avec soi-même</translation>
    </message>
    <message>
        <source>Estimating the map</source>
        <translation>Estimation de la carte</translation>
    </message>
    <message>
        <source>Laying out the band</source>
        <translation>Disposition de la bande</translation>
    </message>
    <message>
        <source>Aggregation</source>
        <translation>Agrégation</translation>
    </message>
    <message>
        <source>Avoids colours that there are too many of already, so that all colours of the exemplar show.</source>
        <translation>Évite les couleurs déjà trop nombreuses, pour que toutes celles de l’échantillon paraissent.</translation>
    </message>
    <message>
        <source>Blend</source>
        <translation>Fondre</translation>
    </message>
    <message>
        <source>Bootstrap</source>
        <translation>Bootstrap</translation>
    </message>
    <message>
        <source>Both directions</source>
        <translation>Les deux sens</translation>
    </message>
    <message>
        <source>Changes the whole output until all its patches are like patches of the exemplar, from coarse to fine and with ever smaller patches. Smooth joins and good large structure; may simplify what is irregular.</source>
        <translation>Modifie toute la sortie jusqu’à ce que tous ses patchs ressemblent à ceux de l’échantillon, du grossier au fin et avec des patchs toujours plus petits. Raccords lisses et bonne grande structure ; peut simplifier l’irrégulier.</translation>
    </message>
    <message>
        <source>Coarse iterations</source>
        <translation>Itérations grossières</translation>
    </message>
    <message>
        <source>Colour histograms apart</source>
        <translation>Écart des histogrammes de couleur</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copier</translation>
    </message>
    <message>
        <source>Copying pixels</source>
        <translation>Copie des pixels</translation>
    </message>
    <message>
        <source>Douglas–Rachford</source>
        <translation>Douglas–Rachford</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Dupliquer</translation>
    </message>
    <message>
        <source>Energy of a patch</source>
        <translation>Énergie d’un patch</translation>
    </message>
    <message>
        <source>Every patch of the exemplar looks for its place in the output, too, so that less gets lost.</source>
        <translation>Chaque patch de l’échantillon cherche aussi sa place dans la sortie, pour que moins se perde.</translation>
    </message>
    <message>
        <source>Exact</source>
        <translation>Exacte</translation>
    </message>
    <message>
        <source>Fine iterations</source>
        <translation>Itérations fines</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>Finition</translation>
    </message>
    <message>
        <source>For outputs of another size than the exemplar&apos;s: all patches equally often, or patches drawn at random.</source>
        <translation>Pour une sortie d’une autre taille que l’échantillon : tous les patchs aussi souvent, ou des patchs tirés au hasard.</translation>
    </message>
    <message>
        <source>Forward share</source>
        <translation>Part directe</translation>
    </message>
    <message>
        <source>Geometric median</source>
        <translation>Médiane géométrique</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Grille</translation>
    </message>
    <message>
        <source>How much a patch that is used too often is avoided: larger shows all of the exemplar, 0 takes whatever fits best.</source>
        <translation>À quel point un patch trop employé est évité : plus montre tout l’échantillon, 0 prend ce qui convient le mieux.</translation>
    </message>
    <message>
        <source>How much the output&apos;s patches count against the exemplar&apos;s: larger joins better, smaller loses less.</source>
        <translation>Combien comptent les patchs de la sortie face à ceux de l’échantillon : plus raccorde mieux, moins perd moins.</translation>
    </message>
    <message>
        <source>How much worse than the best an assignment may be for each patch: 0 for the best, 1 or 2 is faster and looks as good.</source>
        <translation>De combien une affectation peut être moins bonne que la meilleure pour chaque patch : 0 pour la meilleure, 1 ou 2 est plus rapide et aussi beau.</translation>
    </message>
    <message>
        <source>How overlapping patches are joined: the mean (r = 2) blurs, robust weights (r = 0.8) and the geometric median stay sharp.</source>
        <translation>Comment se joignent les patchs qui se recouvrent : la moyenne (r = 2) floute, les poids robustes (r = 0,8) et la médiane géométrique restent nets.</translation>
    </message>
    <message>
        <source>How the geometric median of overlapping patches is found; the result is the same to four digits.</source>
        <translation>Comment est trouvée la médiane géométrique des patchs qui se recouvrent ; le résultat est le même à quatre chiffres.</translation>
    </message>
    <message>
        <source>Hybrid</source>
        <translation>Hybride</translation>
    </message>
    <message>
        <source>Judging the result</source>
        <translation>Évaluation du résultat</translation>
    </message>
    <message>
        <source>Keeps the joined patches, or copies for each pixel the exemplar&apos;s nearest to it: sharper, with an exact map.</source>
        <translation>Garde les patchs joints, ou copie pour chaque pixel le plus proche de l’échantillon : plus net, avec une carte exacte.</translation>
    </message>
    <message>
        <source>Largest patch</source>
        <translation>Plus grand patch</translation>
    </message>
    <message>
        <source>Largest verbatim region, %</source>
        <translation>Plus grande zone copiée, %</translation>
    </message>
    <message>
        <source>Lets overlapping patches of the output find similar ones in the exemplar, from coarse to fine, and copies the pixels that most of them agree on. Very fast, at its best on textures without large structure.</source>
        <translation>Laisse les patchs qui se recouvrent trouver leurs semblables dans l’échantillon, du grossier au fin, et copie les pixels sur lesquels la plupart s’accordent. Très rapide, au mieux sur des textures sans grande structure.</translation>
    </message>
    <message>
        <source>Lets patches be used more or less often, so that what fits nowhere may be left out.</source>
        <translation>Permet d’employer des patchs plus ou moins souvent, pour laisser de côté ce qui ne va nulle part.</translation>
    </message>
    <message>
        <source>Match colours</source>
        <translation>Accorder les couleurs</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Moyenne</translation>
    </message>
    <message>
        <source>Mean cost of a patch</source>
        <translation>Coût moyen d’un patch</translation>
    </message>
    <message>
        <source>Mean distance of the patches</source>
        <translation>Distance moyenne des patchs</translation>
    </message>
    <message>
        <source>Median</source>
        <translation>Médiane</translation>
    </message>
    <message>
        <source>Occurrence</source>
        <translation>Occurrence</translation>
    </message>
    <message>
        <source>Patch assignment</source>
        <translation>Affectation de patchs</translation>
    </message>
    <message>
        <source>Patch-occurrence entropy</source>
        <translation>Entropie d’occurrence des patchs</translation>
    </message>
    <message>
        <source>PatchMatch</source>
        <translation>PatchMatch</translation>
    </message>
    <message>
        <source>Patches apart, first principal axis</source>
        <translation>Écart des patchs, premier axe principal</translation>
    </message>
    <message>
        <source>Patches apart, second principal axis</source>
        <translation>Écart des patchs, second axe principal</translation>
    </message>
    <message>
        <source>Patches apart, sliced Wasserstein</source>
        <translation>Écart des patchs, Wasserstein tranché</translation>
    </message>
    <message>
        <source>Patches apart, sliced Wasserstein at half scale</source>
        <translation>Écart des patchs, Wasserstein tranché, demi-échelle</translation>
    </message>
    <message>
        <source>Patches apart, sliced Wasserstein at quarter scale</source>
        <translation>Écart des patchs, Wasserstein tranché, quart d’échelle</translation>
    </message>
    <message>
        <source>Patches shrink from this size to 8 px by halves: larger ones keep larger structures whole.</source>
        <translation>Les patchs diminuent de moitié de cette taille jusqu’à 8 px : les plus grands gardent entières de plus grandes structures.</translation>
    </message>
    <message>
        <source>Random</source>
        <translation>Aléatoire</translation>
    </message>
    <message>
        <source>Regular</source>
        <translation>Régulière</translation>
    </message>
    <message>
        <source>Relaxed</source>
        <translation>Relâché</translation>
    </message>
    <message>
        <source>Robust</source>
        <translation>Robuste</translation>
    </message>
    <message>
        <source>Robust, Gaussian falloff</source>
        <translation>Robuste, décroissance gaussienne</translation>
    </message>
    <message>
        <source>Rounds of matching and voting on each scale: more join better, but take longer.</source>
        <translation>Passes d’appariement et de vote à chaque échelle : davantage raccorde mieux, mais prend plus de temps.</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Recherche</translation>
    </message>
    <message>
        <source>Side of the patches, which lie a quarter of it apart: larger keeps larger structures, smaller varies more.</source>
        <translation>Côté des patchs, espacés d’un quart : plus garde de plus grandes structures, moins varie davantage.</translation>
    </message>
    <message>
        <source>Supply</source>
        <translation>Réserve</translation>
    </message>
    <message>
        <source>Texture optimisation</source>
        <translation>Optimisation de texture</translation>
    </message>
    <message>
        <source>Tracing the pixels</source>
        <translation>Suivi des pixels</translation>
    </message>
    <message>
        <source>Uniformity</source>
        <translation>Uniformité</translation>
    </message>
    <message>
        <source>Uses every patch of the exemplar as often as every other, so that nothing gets lost and nothing takes over. Keeps the exemplar&apos;s mix of colours and details; slow for large outputs.</source>
        <translation>Emploie chaque patch de l’échantillon aussi souvent que tout autre, pour que rien ne se perde ni ne domine. Garde le mélange de couleurs et de détails ; lent pour les grandes sorties.</translation>
    </message>
    <message>
        <source>Weiszfeld</source>
        <translation>Weiszfeld</translation>
    </message>
    <message>
        <source>What each use too many or too few costs: 0 takes the nearest patches, a large value uses all alike.</source>
        <translation>Ce que coûte chaque emploi en trop ou en moins : 0 prend les patchs les plus proches, une grande valeur les emploie tous également.</translation>
    </message>
    <message>
        <source>Where the exemplar&apos;s patches lie: a regular grid is sharp and copies larger pieces, a random one varies more and blurs, the hybrid is random but on the finest scale.</source>
        <translation>Où se trouvent les patchs de l’échantillon : une grille régulière est nette et copie de plus grands morceaux, une aléatoire varie plus et floute, l’hybride est aléatoire sauf à l’échelle la plus fine.</translation>
    </message>
    <message>
        <source>Always</source>
        <translation>Toujours</translation>
    </message>
    <message>
        <source>Never</source>
        <translation>Jamais</translation>
    </message>
    <message>
        <source>Where patches would show</source>
        <translation>Là où des pièces se verraient</translation>
    </message>
    <message>
        <source>Coarsest stitch</source>
        <translation>Couture grossière</translation>
    </message>
    <message>
        <source>Contrast</source>
        <translation>Contraste</translation>
    </message>
    <message>
        <source>How far flat patches are kept from winning where nothing fits well: 1 holds the exemplar&apos;s contrast; 0 compares as published, and outputs may fade.</source>
        <translation>À quel point les patchs plats sont empêchés de gagner là où rien ne convient : 1 tient le contraste de l’échantillon ; 0 compare comme publié, et les résultats peuvent s’affadir.</translation>
    </message>
    <message>
        <source>How patches join at all scales but the coarsest: along the cut of least error, blended, or pasted, as published.</source>
        <translation>Comment les patchs se joignent à toutes les échelles sauf la plus grossière : le long de la coupe d’erreur minimale, fondus, ou collés, comme publié.</translation>
    </message>
    <message>
        <source>How patches join at the coarsest scale: the cut keeps contrast that the average, as published, loses.</source>
        <translation>Comment les patchs se joignent à l’échelle la plus grossière : la coupe garde le contraste que la moyenne, publiée, perd.</translation>
    </message>
    <message>
        <source>A batch is a JSON object; this is not one.</source>
        <translation>Un lot est un objet JSON ; ceci n’en est pas un.</translation>
    </message>
    <message>
        <source>A recipe is a JSON object; this is not one.</source>
        <translation>Une recette est un objet JSON ; ceci n’en est pas un.</translation>
    </message>
    <message>
        <source>A session is a JSON object; this is not one.</source>
        <translation>Une session est un objet JSON ; ceci n’en est pas un.</translation>
    </message>
    <message>
        <source>A sheet of {} × {} pictures of {} px is too large; compare fewer.</source>
        <translation>Une planche de {} × {} images de {} px est trop grande ; comparez-en moins.</translation>
    </message>
    <message>
        <source>An image of {} × {} px with {} channels has no pixels.</source>
        <translation>Une image de {} × {} px à {} canaux n’a pas de pixels.</translation>
    </message>
    <message>
        <source>An output of {} × {} px cannot wrap with a lattice of {:.0f} × {:.0f} px; make it at least that large, or set lattice=none.</source>
        <translation>Une sortie de {} × {} px ne peut se raccorder avec un réseau de {} × {} px ; donnez-lui au moins cette taille, ou lattice=none.</translation>
    </message>
    <message>
        <source>An output of {} × {} px cannot wrap with a tile of {:.0f} × {:.0f} px; make it at least that large.</source>
        <translation>Une sortie de {} × {} px ne peut se raccorder avec un carreau de {} × {} px ; donnez-lui au moins cette taille.</translation>
    </message>
    <message>
        <source>At the coarsest of {} scales {} is {} × {} px, smaller than the patch of {} px; choose fewer scales or a smaller patch.</source>
        <translation>À la plus grossière des {} échelles, {} fait {} × {} px, moins que le patch de {} px ; choisissez moins d’échelles ou un patch plus petit.</translation>
    </message>
    <message>
        <source>Corner {} of the rectification lies at {:.1f}, {:.1f}, outside the image of {} × {} px.</source>
        <translation>Le coin {} du redressement est à {}, {}, hors de l’image de {} × {} px.</translation>
    </message>
    <message>
        <source>Finding the lattice takes {}, of which only {} are free; open a smaller exemplar.</source>
        <translation>Trouver le réseau demande {}, dont seuls {} sont libres ; ouvrez un modèle plus petit.</translation>
    </message>
    <message>
        <source>No tile fits in the exemplar of {} × {} px.</source>
        <translation>Aucun carreau ne tient dans le modèle de {} × {} px.</translation>
    </message>
    <message>
        <source>Portilla–Simoncelli learns from one exemplar or goes between 2, but {} were given.</source>
        <translation>Portilla–Simoncelli apprend d’un modèle ou va de l’un à l’autre de 2, mais {} ont été donnés.</translation>
    </message>
    <message>
        <source>The band of {} px must be from 2 px to half the images&apos; shorter side, {} px.</source>
        <translation>La bande de {} px doit aller de 2 px à la moitié du petit côté des images, {} px.</translation>
    </message>
    <message>
        <source>The batch holds more than {} runs; divide it.</source>
        <translation>Le lot contient plus de {} calculs ; divisez-le.</translation>
    </message>
    <message>
        <source>The batch is of format {}, made for a newer Texloom; this one reads up to {}.</source>
        <translation>Le lot est au format {}, pour un Texloom plus récent ; celui-ci lit jusqu’à {}.</translation>
    </message>
    <message>
        <source>The batch&apos;s {} and {} would both write {}; put $index, or what sets them apart, into the name.</source>
        <translation>{} et {} du lot écriraient tous deux {} ; mettez $index, ou ce qui les distingue, dans le nom.</translation>
    </message>
    <message>
        <source>The crop of {} × {} px at {}, {} does not lie within the image of {} × {} px.</source>
        <translation>Le rognage de {} × {} px en {}, {} ne tient pas dans l’image de {} × {} px.</translation>
    </message>
    <message>
        <source>The first image is {} × {} px, the second {} × {} px; crop one to the size of the other.</source>
        <translation>La première image fait {} × {} px, la seconde {} × {} px ; rognez l’une à la taille de l’autre.</translation>
    </message>
    <message>
        <source>The folder {} cannot be made: {}.</source>
        <translation>Le dossier {} ne peut être créé : {}.</translation>
    </message>
    <message>
        <source>The image is {} × {} px, but the map was made from an exemplar of {} × {} px.</source>
        <translation>L’image fait {} × {} px, mais la carte vient d’un modèle de {} × {} px.</translation>
    </message>
    <message>
        <source>The images have {} and {} channels; a map needs the same number in each.</source>
        <translation>Les images ont {} et {} canaux ; une carte en veut autant dans chacune.</translation>
    </message>
    <message>
        <source>The lattice&apos;s tile of {:.0f} × {:.0f} px is larger than {} with {} × {} px; give shorter vectors, or set lattice=none.</source>
        <translation>La maille du réseau, de {} × {} px, dépasse {} avec {} × {} px ; donnez des vecteurs plus courts, ou lattice=none.</translation>
    </message>
    <message>
        <source>The map needs the images that it was made from, but none was given.</source>
        <translation>La carte demande les images dont elle vient, mais aucune n’a été donnée.</translation>
    </message>
    <message>
        <source>The mask hides all of {}; mask less.</source>
        <translation>Le masque cache tout {} ; masquez moins.</translation>
    </message>
    <message>
        <source>The mask leaves no whole patch of {} px to copy; choose smaller blocks or mask less.</source>
        <translation>Le masque ne laisse aucun patch entier de {} px à copier ; choisissez des blocs plus petits ou masquez moins.</translation>
    </message>
    <message>
        <source>The mask leaves no whole tile of {:.0f} × {:.0f} px to copy; mask less.</source>
        <translation>Le masque ne laisse aucun carreau entier de {} × {} px à copier ; masquez moins.</translation>
    </message>
    <message>
        <source>The name {} holds a $ without a word after it; write $$ for a dollar sign.</source>
        <translation>Le nom {} contient un $ sans mot derrière ; écrivez $$ pour un signe dollar.</translation>
    </message>
    <message>
        <source>The output cannot be {} × {} px: its sides go from 1 to {} px.</source>
        <translation>La sortie ne peut faire {} × {} px : ses côtés vont de 1 à {} px.</translation>
    </message>
    <message>
        <source>The pasted picture could not be kept in {}; check that there is room.</source>
        <translation>L’image collée n’a pu être gardée dans {} ; vérifiez qu’il y a de la place.</translation>
    </message>
    <message>
        <source>The preset is of format {}, made by a newer Texloom; this one ({}) reads up to {}.</source>
        <translation>Le préréglage est au format {}, d’un Texloom plus récent ; celui-ci ({}) lit jusqu’à {}.</translation>
    </message>
    <message>
        <source>The recipe is of format {}, made by a newer Texloom; this one ({}) reads up to {}.</source>
        <translation>La recette est au format {}, d’un Texloom plus récent ; celui-ci ({}) lit jusqu’à {}.</translation>
    </message>
    <message>
        <source>The rectified image would be {} × {} px; each side is 1 to {} px.</source>
        <translation>L’image redressée ferait {} × {} px ; chaque côté va de 1 à {} px.</translation>
    </message>
    <message>
        <source>The region of {} × {} px at ({}, {}) does not lie in the output of {} × {} px.</source>
        <translation>La partie de {} × {} px en ({}, {}) n’est pas dans la sortie de {} × {} px.</translation>
    </message>
    <message>
        <source>The seed “{}” is not a whole number from 0 to {}.</source>
        <translation>La graine « {} » n’est pas un entier de 0 à {}.</translation>
    </message>
    <message>
        <source>The session has no exemplar in use.</source>
        <translation>La session n’a pas de modèle en usage.</translation>
    </message>
    <message>
        <source>The session is of format {}, made by a newer Texloom; this one ({}) reads up to {}.</source>
        <translation>La session est au format {}, d’un Texloom plus récent ; celui-ci ({}) lit jusqu’à {}.</translation>
    </message>
    <message>
        <source>The sweep&apos;s {} is for {}, which is not one of the methods of this run.</source>
        <translation>{} de la série est pour {}, qui n’est pas une méthode de ce calcul.</translation>
    </message>
    <message>
        <source>The tile at ({}, {}) holds pixels that the mask hides; choose another corner.</source>
        <translation>Le carreau en ({}, {}) contient des pixels que le masque cache ; choisissez un autre coin.</translation>
    </message>
    <message>
        <source>The tile&apos;s corner ({}, {}) lies outside {} with {} × {} px.</source>
        <translation>Le coin ({}, {}) du carreau est hors de {} avec {} × {} px.</translation>
    </message>
    <message>
        <source>The weight of {} is {}; it goes from {} to {}.</source>
        <translation>Le poids de {} est {} ; il va de {} à {}.</translation>
    </message>
    <message>
        <source>The {} has no {}.</source>
        <translation>{} : {} manque.</translation>
    </message>
    <message>
        <source>The {} holds a number that is too large.</source>
        <translation>{} : un nombre y est trop grand.</translation>
    </message>
    <message>
        <source>The {} is nested more than {} levels deep.</source>
        <translation>{} : imbriqué sur plus de {} niveaux.</translation>
    </message>
    <message>
        <source>The {} is not JSON: it breaks off or goes wrong at byte {}.</source>
        <translation>{} : pas du JSON ; il s’arrête ou devient faux à l’octet {}.</translation>
    </message>
    <message>
        <source>The {}&apos;s {} is {}; it must be {}.</source>
        <translation>{} : {} est {} ; il faut {}.</translation>
    </message>
    <message>
        <source>There are no values for {}.</source>
        <translation>Il n’y a pas de valeurs pour {}.</translation>
    </message>
    <message>
        <source>There is no exemplar to learn from.</source>
        <translation>Il n’y a pas de modèle dont apprendre.</translation>
    </message>
    <message>
        <source>There is no file {}.</source>
        <translation>Il n’y a pas de fichier {}.</translation>
    </message>
    <message>
        <source>There is not enough memory for an image of {} × {} px with {} channels ({}).</source>
        <translation>La mémoire manque pour une image de {} × {} px à {} canaux ({}).</translation>
    </message>
    <message>
        <source>These are {} runs; a sweep has at most {}.</source>
        <translation>Cela fait {} calculs ; une série en a au plus {}.</translation>
    </message>
    <message>
        <source>To wrap at {} × {} px the lattice was changed by {:.1f} %; a multiple of {} × {} px needs no change.</source>
        <translation>Pour se raccorder à {} × {} px, le réseau a été changé de {} % ; un multiple de {} × {} px ne demande aucun changement.</translation>
    </message>
    <message>
        <source>To wrap at {} × {} px the tile was changed by {:.1f} %; a multiple of {} × {} px needs no change.</source>
        <translation>Pour se raccorder à {} × {} px, le carreau a été changé de {} % ; un multiple de {} × {} px ne demande aucun changement.</translation>
    </message>
    <message>
        <source>To wrap, the output of {} × {} px at the coarsest of {} scales must be at least the patch, {} px; choose fewer scales or a smaller patch.</source>
        <translation>Pour se raccorder, la sortie de {} × {} px à la plus grossière des {} échelles doit faire au moins le patch, {} px ; choisissez moins d’échelles ou un patch plus petit.</translation>
    </message>
    <message>
        <source>To wrap, the output&apos;s {} of {} px must be at least the patch, {} px.</source>
        <translation>Pour se raccorder, la sortie ({}) de {} px doit faire au moins le patch, {} px.</translation>
    </message>
    <message>
        <source>To wrap, the output&apos;s {} of {} px must be at least {} px.</source>
        <translation>Pour se raccorder, la sortie ({}) de {} px doit faire au moins {} px.</translation>
    </message>
    <message>
        <source>Turned by {}°, too little of the image of {} × {} px would be left.</source>
        <translation>Tournée de {}°, il resterait trop peu de l’image de {} × {} px.</translation>
    </message>
    <message>
        <source>Weights of exemplars</source>
        <translation>Poids des modèles</translation>
    </message>
    <message>
        <source>With two exemplars, how far the statistics go from the first to the second, before their own weights.</source>
        <translation>Avec deux modèles, jusqu’où les statistiques vont du premier au second, avant leurs propres poids.</translation>
    </message>
    <message>
        <source>companion map</source>
        <translation>carte associée</translation>
    </message>
    <message>
        <source>off</source>
        <translation>désactivé</translation>
    </message>
    <message>
        <source>on</source>
        <translation>activé</translation>
    </message>
    <message>
        <source>position map (16-bit)</source>
        <translation>carte de position (16 bits)</translation>
    </message>
    <message>
        <source>position map (STMap)</source>
        <translation>carte de position (STMap)</translation>
    </message>
    <message>
        <source>recipe</source>
        <translation>recette</translation>
    </message>
    <message>
        <source>result</source>
        <translation>résultat</translation>
    </message>
    <message>
        <source>{} cannot be read: this build has no reader for {}.</source>
        <translation>{} ne peut être lu : cette version n’a pas de lecteur pour {}.</translation>
    </message>
    <message>
        <source>{} cannot be read: {}.</source>
        <translation>{} ne peut être lu : {}.</translation>
    </message>
    <message>
        <source>{} cannot be written: it is a folder.</source>
        <translation>{} ne peut être écrit : c’est un dossier.</translation>
    </message>
    <message>
        <source>{} cannot be written: the folder {} is not writable.</source>
        <translation>{} ne peut être écrit : le dossier {} est protégé.</translation>
    </message>
    <message>
        <source>{} cannot be written: the image has {} channels, and {} holds {}.</source>
        <translation>{} ne peut être écrit : l’image a {} canaux, et {} en contient {}.</translation>
    </message>
    <message>
        <source>{} cannot be written: the name ends in {}; Texloom writes .png, .jpg, .tif, .exr and .hdr.</source>
        <translation>{} ne peut être écrit : le nom finit par {} ; Texloom écrit .png, .jpg, .tif, .exr et .hdr.</translation>
    </message>
    <message>
        <source>{} cannot be written: there is no folder {}.</source>
        <translation>{} ne peut être écrit : il n’y a pas de dossier {}.</translation>
    </message>
    <message>
        <source>{} cannot be written: {} does not hold {} samples.</source>
        <translation>{} ne peut être écrit : {} ne contient pas de valeurs {}.</translation>
    </message>
    <message>
        <source>{} cannot be written: {}.</source>
        <translation>{} ne peut être écrit : {}.</translation>
    </message>
    <message>
        <source>{} cannot hold a position map; its name ends in .exr (STMap, float) or .png (16-bit).</source>
        <translation>{} ne peut contenir de carte de position ; son nom finit par .exr (STMap, flottant) ou .png (16 bits).</translation>
    </message>
    <message>
        <source>{} cannot make a part of an output alone; make all of it.</source>
        <translation>{} ne peut faire seule une partie d’une sortie ; faites-la entière.</translation>
    </message>
    <message>
        <source>{} cannot make an output that wraps.</source>
        <translation>{} ne peut faire de sortie qui se raccorde.</translation>
    </message>
    <message>
        <source>{} cannot start from an image.</source>
        <translation>{} ne peut partir d’une image.</translation>
    </message>
    <message>
        <source>{} changed since this result was made.</source>
        <translation>{} a changé depuis que ce résultat a été fait.</translation>
    </message>
    <message>
        <source>{} could not be copied to {}: {}.</source>
        <translation>{} n’a pu être copié vers {} : {}.</translation>
    </message>
    <message>
        <source>{} does not say the size of its exemplar; name the exemplar too.</source>
        <translation>{} ne dit pas la taille de son modèle ; nommez aussi le modèle.</translation>
    </message>
    <message>
        <source>{} has no pixels.</source>
        <translation>{} n’a pas de pixels.</translation>
    </message>
    <message>
        <source>{} has {} channels; images with up to {} can be opened.</source>
        <translation>{} a {} canaux ; on peut ouvrir des images jusqu’à {}.</translation>
    </message>
    <message>
        <source>{} holds no recipe.</source>
        <translation>{} ne contient pas de recette.</translation>
    </message>
    <message>
        <source>{} is a {} image; only flat ones can be opened.</source>
        <translation>{} est une image {} ; seules les images plates s’ouvrent.</translation>
    </message>
    <message>
        <source>{} is empty (0 bytes).</source>
        <translation>{} est vide (0 octet).</translation>
    </message>
    <message>
        <source>{} is not an image that Texloom reads (PNG, JPEG, TIFF, EXR or HDR).</source>
        <translation>{} n’est pas une image que Texloom lit (PNG, JPEG, TIFF, EXR ou HDR).</translation>
    </message>
    <message>
        <source>{} is not of the result&apos;s size.</source>
        <translation>{} n’a pas la taille du résultat.</translation>
    </message>
    <message>
        <source>{} is {} × {} px, smaller than the patch of {} px; choose a patch of at most {} px.</source>
        <translation>{} fait {} × {} px, moins que le patch de {} px ; choisissez un patch d’au plus {} px.</translation>
    </message>
    <message>
        <source>{} is {} × {} px, too small for blocks of {} px with their borders; choose blocks of at most {} px.</source>
        <translation>{} fait {} × {} px, trop peu pour des blocs de {} px avec leurs bords ; choisissez des blocs d’au plus {} px.</translation>
    </message>
    <message>
        <source>{} is {} × {} px; a tile is looked for in exemplars of at least {} × {} px.</source>
        <translation>{} fait {} × {} px ; un carreau se cherche dans des modèles d’au moins {} × {} px.</translation>
    </message>
    <message>
        <source>{} is {} × {} px; an exemplar&apos;s sides go up to {} px.</source>
        <translation>{} fait {} × {} px ; les côtés d’un modèle vont jusqu’à {} px.</translation>
    </message>
    <message>
        <source>{} is {} × {} px; images up to {} pixels can be opened.</source>
        <translation>{} fait {} × {} px ; on peut ouvrir des images jusqu’à {} pixels.</translation>
    </message>
    <message>
        <source>{} is {} × {} px; near-regular synthesis needs exemplars of at least {} × {} px.</source>
        <translation>{} fait {} × {} px ; la synthèse presque régulière veut des modèles d’au moins {} × {} px.</translation>
    </message>
    <message>
        <source>{} learns from one exemplar, but {} were given.</source>
        <translation>{} apprend d’un modèle, mais {} ont été donnés.</translation>
    </message>
    <message>
        <source>{} says it is {} × {} px; an EXR&apos;s sides can go up to {} px.</source>
        <translation>{} dit faire {} × {} px ; les côtés d’un EXR vont jusqu’à {} px.</translation>
    </message>
    <message>
        <source>{} takes {}, of which only {} are free; make a smaller result.</source>
        <translation>{} demande {}, dont seuls {} sont libres ; faites un résultat plus petit.</translation>
    </message>
    <message>
        <source>{}: output pixel ({}, {}) comes from {:.2f}, between two pixels; a position map addresses whole ones (was it resampled, or is it for an exemplar of another size?).</source>
        <translation>{} : le pixel ({}, {}) de la sortie vient de {}, entre deux pixels ; une carte de position en nomme d’entiers (a-t-elle été rééchantillonnée, ou est-elle pour un modèle d’une autre taille ?).</translation>
    </message>
    <message>
        <source>{}: output pixel ({}, {}) comes from {:.2f}, outside the exemplar&apos;s 0 to {}.</source>
        <translation>{} : le pixel ({}, {}) de la sortie vient de {}, hors de 0 à {} du modèle.</translation>
    </message>
    <message>
        <source>“{}” is not from:to:count, such as 8:64:5, with a count of 2 to {}.</source>
        <translation>« {} » n’est pas de:à:nombre, comme 8:64:5, avec un nombre de 2 à {}.</translation>
    </message>
    <message>
        <source>A box of {} voxels is empty; each side must be at least 1.</source>
        <translation>Une boîte de {} voxels est vide ; chaque côté doit valoir au moins 1.</translation>
    </message>
    <message>
        <source>A box of {} voxels takes {}, and {} of memory are free; ask for smaller ones.</source>
        <translation>Une boîte de {} voxels prend {}, et {} de mémoire sont libres ; demandez-en de plus petites.</translation>
    </message>
    <message>
        <source>A slice goes {} voxels from pixel to pixel; it must be more than 0 and up to {}.</source>
        <translation>Une coupe avance de {} voxels d’un pixel à l’autre ; il en faut plus de 0 et au plus {}.</translation>
    </message>
    <message>
        <source>A slice of {} × {} px has no pixels.</source>
        <translation>Une coupe de {} × {} px n’a aucun pixel.</translation>
    </message>
    <message>
        <source>A volume of {} voxels with {} channels has no voxels.</source>
        <translation>Un volume de {} voxels à {} canaux n’a aucun voxel.</translation>
    </message>
    <message>
        <source>The box from ({}, {}, {}) on lies too far out; coordinates go from −{} to {}.</source>
        <translation>La boîte à partir de ({}, {}, {}) est trop éloignée ; les coordonnées vont de −{} à {}.</translation>
    </message>
    <message>
        <source>The box {} is not all within the volume, which has {}.</source>
        <translation>La boîte {} n’est pas tout entière dans le volume, qui a {}.</translation>
    </message>
    <message>
        <source>The model of kind {} has no array {}; it was made by another version.</source>
        <translation>Le modèle de type {} n’a pas de tableau {} ; il vient d’une autre version.</translation>
    </message>
    <message>
        <source>The model&apos;s array {} has {} values and a shape of {}.</source>
        <translation>Le tableau {} du modèle a {} valeurs et la forme {}.</translation>
    </message>
    <message>
        <source>The model&apos;s array {} holds {} {}; {} {} are needed.</source>
        <translation>Le tableau {} du modèle contient {} {} ; il faut {} {}.</translation>
    </message>
    <message>
        <source>The slice lies beside the volume, which has {}.</source>
        <translation>La coupe passe à côté du volume, qui a {}.</translation>
    </message>
    <message>
        <source>The slice lies too far out; coordinates go from −{} to {}.</source>
        <translation>La coupe est trop éloignée ; les coordonnées vont de −{} à {}.</translation>
    </message>
    <message>
        <source>The slice {} is missing; there are others from {} to {}.</source>
        <translation>La coupe {} manque ; il y en a d’autres de {} à {}.</translation>
    </message>
    <message>
        <source>There is not enough memory for a volume of {} voxels with {} channels ({}).</source>
        <translation>La mémoire manque pour un volume de {} voxels à {} canaux ({}).</translation>
    </message>
    <message>
        <source>{} and {} have the same number; slices of a volume are numbered one by one.</source>
        <translation>{} et {} portent le même numéro ; les coupes d’un volume sont numérotées une à une.</translation>
    </message>
    <message>
        <source>{} became shorter while it was read.</source>
        <translation>{} a raccourci pendant sa lecture.</translation>
    </message>
    <message>
        <source>{} does not describe a volume.</source>
        <translation>{} ne décrit pas de volume.</translation>
    </message>
    <message>
        <source>{} has a face of {} corners; faces can have up to {}.</source>
        <translation>{} a une face de {} sommets ; une face en a au plus {}.</translation>
    </message>
    <message>
        <source>{} has faces without a list of vertices.</source>
        <translation>{} a des faces sans liste de sommets.</translation>
    </message>
    <message>
        <source>{} has more than {} normals; no mesh can have more.</source>
        <translation>{} a plus de {} normales ; aucun maillage ne peut en avoir plus.</translation>
    </message>
    <message>
        <source>{} has more than {} texture coordinates; no mesh can have more.</source>
        <translation>{} a plus de {} coordonnées de texture ; aucun maillage ne peut en avoir plus.</translation>
    </message>
    <message>
        <source>{} has more than {} triangles; no mesh can have more.</source>
        <translation>{} a plus de {} triangles ; aucun maillage ne peut en avoir plus.</translation>
    </message>
    <message>
        <source>{} has more than {} vertices; no mesh can have more.</source>
        <translation>{} a plus de {} sommets ; aucun maillage ne peut en avoir plus.</translation>
    </message>
    <message>
        <source>{} has no faces with an area ({} without one); there is nothing to see.</source>
        <translation>{} n’a aucune face d’aire non nulle ({} d’aire nulle) ; il n’y a rien à voir.</translation>
    </message>
    <message>
        <source>{} has vertices without x, y and z.</source>
        <translation>{} a des sommets sans x, y et z.</translation>
    </message>
    <message>
        <source>{} has {} bytes; {} voxels with {} channels, as {} says, take {}.</source>
        <translation>{} a {} octets ; {} voxels à {} canaux, comme le dit {}, en prennent {}.</translation>
    </message>
    <message>
        <source>{} holds arrays, but is no model of Texloom: its head names no kind of model.</source>
        <translation>{} contient des tableaux, mais n’est pas un modèle de Texloom : son en-tête ne nomme aucun type de modèle.</translation>
    </message>
    <message>
        <source>{} holds values at z = {} that are not finite numbers; Texloom needs finite ones.</source>
        <translation>{} contient à z = {} des valeurs qui ne sont pas des nombres finis ; il en faut de finis à Texloom.</translation>
    </message>
    <message>
        <source>{} holds values in its array {} that are not finite numbers; Texloom needs finite ones.</source>
        <translation>{} contient dans son tableau {} des valeurs qui ne sont pas des nombres finis ; il en faut de finis à Texloom.</translation>
    </message>
    <message>
        <source>{} holds {} arrays; a model has up to {}.</source>
        <translation>{} contient {} tableaux ; un modèle en a au plus {}.</translation>
    </message>
    <message>
        <source>{} is a damaged OBJ file.</source>
        <translation>{} est un fichier OBJ abîmé.</translation>
    </message>
    <message>
        <source>file {}</source>
        <translation>fichier {}</translation>
    </message>
    <message>
        <source>{} is a folder, not a file.</source>
        <translation>{} est un dossier, pas un fichier.</translation>
    </message>
    <message>
        <source>{} is not an ordinary file, so it is not read.</source>
        <translation>{} n’est pas un fichier ordinaire et n’est donc pas lu.</translation>
    </message>
    <message>
        <source>32-bit floats</source>
        <translation>flottants de 32 bits</translation>
    </message>
    <message>
        <source>64-bit floats</source>
        <translation>flottants de 64 bits</translation>
    </message>
    <message>
        <source>64-bit integers</source>
        <translation>entiers de 64 bits</translation>
    </message>
    <message>
        <source>the name of a file in the same folder</source>
        <translation>le nom d’un fichier du même dossier</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true ou false</translation>
    </message>
    <message>
        <source>{} or more</source>
        <translation>{} ou plus</translation>
    </message>
    <message>
        <source>a whole number from −{} to {}</source>
        <translation>un nombre entier de −{} à {}</translation>
    </message>
    <message>
        <source>{} is a model in format {}; this Texloom reads formats up to {}. A newer one reads it.</source>
        <translation>{} est un modèle au format {} ; ce Texloom lit les formats jusqu’à {}. Un plus récent le lit.</translation>
    </message>
    <message>
        <source>{} is a volume in format {}; this Texloom reads formats up to {}. A newer one reads it.</source>
        <translation>{} est un volume au format {} ; ce Texloom lit les formats jusqu’à {}. Un plus récent le lit.</translation>
    </message>
    <message>
        <source>{} is a volume of {} channels; volumes with up to {} can be opened.</source>
        <translation>{} est un volume à {} canaux ; on peut ouvrir des volumes jusqu’à {}.</translation>
    </message>
    <message>
        <source>{} is a volume of {} voxels and takes {}; {} of memory are free.</source>
        <translation>{} est un volume de {} voxels et prend {} ; {} de mémoire sont libres.</translation>
    </message>
    <message>
        <source>{} is a volume of {} voxels; volumes up to {} voxels can be opened.</source>
        <translation>{} est un volume de {} voxels ; on peut ouvrir des volumes jusqu’à {} voxels.</translation>
    </message>
    <message>
        <source>{} is damaged or no model: a name in its head is empty, longer than {} bytes or holds control characters.</source>
        <translation>{} est abîmé ou n’est pas un modèle : un nom de son en-tête est vide, dépasse {} octets ou contient des caractères de contrôle.</translation>
    </message>
    <message>
        <source>{} is damaged or no model: its array {} does not say a type (F32, F64 or I64), a shape of up to {} axes and a place.</source>
        <translation>{} est abîmé ou n’est pas un modèle : le tableau {} n’indique pas de type (F32, F64 ou I64), de forme à {} axes au plus ou de place.</translation>
    </message>
    <message>
        <source>{} is damaged or no model: its head is said to have {} bytes; it can have up to {}.</source>
        <translation>{} est abîmé ou n’est pas un modèle : l’en-tête ferait {} octets ; il peut en faire {} au plus.</translation>
    </message>
    <message>
        <source>{} is damaged: a number in it is none.</source>
        <translation>{} est abîmé : il manque un nombre là où il en faut un.</translation>
    </message>
    <message>
        <source>{} is damaged: it breaks off before its last face.</source>
        <translation>{} est abîmé : il s’interrompt avant la dernière face.</translation>
    </message>
    <message>
        <source>{} is damaged: it holds {} where a whole number must be.</source>
        <translation>{} est abîmé : il contient {} là où il faut un nombre entier.</translation>
    </message>
    <message>
        <source>{} is damaged: its array {} begins at byte {}, not at {} where the one before it ends.</source>
        <translation>{} est abîmé : le tableau {} commence à l’octet {}, et non à {} où finit le précédent.</translation>
    </message>
    <message>
        <source>{} is damaged: its array {} has a shape of {} and room from byte {} to {}.</source>
        <translation>{} est abîmé : le tableau {} a la forme {} et de la place de l’octet {} à {}.</translation>
    </message>
    <message>
        <source>{} is damaged: its arrays take {} bytes, and it holds {}.</source>
        <translation>{} est abîmé : ses tableaux prennent {} octets, et il en contient {}.</translation>
    </message>
    <message>
        <source>{} is damaged: its head has the line “{}”.</source>
        <translation>{} est abîmé : son en-tête a la ligne « {} ».</translation>
    </message>
    <message>
        <source>{} is damaged: {} numbers of a surface do not lie within the {} bytes of their buffer.</source>
        <translation>{} est abîmé : {} nombres d’une surface ne tiennent pas dans les {} octets de leur tampon.</translation>
    </message>
    <message>
        <source>{} is no PLY file that can be read: its head does not end, or does not say its format.</source>
        <translation>{} n’est pas un fichier PLY lisible : son en-tête ne finit pas, ou ne dit pas son format.</translation>
    </message>
    <message>
        <source>{} is no model of Texloom: its format is {}, not a number.</source>
        <translation>{} n’est pas un modèle de Texloom : son format est {}, et non un nombre.</translation>
    </message>
    <message>
        <source>{} is no model: it has {} bytes.</source>
        <translation>{} n’est pas un modèle : il a {} octets.</translation>
    </message>
    <message>
        <source>{} is no model: its head is not JSON.</source>
        <translation>{} n’est pas un modèle : son en-tête n’est pas du JSON.</translation>
    </message>
    <message>
        <source>{} is no slice of a volume: its name does not end in a number of up to {} digits.</source>
        <translation>{} n’est pas une coupe d’un volume : son nom ne finit pas par un nombre de {} chiffres au plus.</translation>
    </message>
    <message>
        <source>{} is not a mesh that Texloom reads (OBJ, PLY or glTF).</source>
        <translation>{} n’est pas un maillage que lit Texloom (OBJ, PLY ou glTF).</translation>
    </message>
    <message>
        <source>{} is not the file that {} was written for: its SHA-1 is another.</source>
        <translation>{} n’est pas le fichier pour lequel {} a été écrit : son SHA-1 est différent.</translation>
    </message>
    <message>
        <source>{} already exists and would be taken for a part of this volume of {} slices; remove it or choose another name.</source>
        <translation>{} existe déjà et passerait pour une partie de ce volume de {} coupes ; supprimez-le ou choisissez un autre nom.</translation>
    </message>
    <message>
        <source>{} is {} long; a glTF file can have up to {}.</source>
        <translation>{} fait {} ; un fichier glTF en fait au plus {}.</translation>
    </message>
    <message>
        <source>{} is {} long; models are read up to {}.</source>
        <translation>{} fait {} ; les modèles sont lus jusqu’à {}.</translation>
    </message>
    <message>
        <source>{} needs the extension {}, which Texloom does not read; save it without compression.</source>
        <translation>{} demande l’extension {}, que Texloom ne lit pas ; enregistrez-le sans compression.</translation>
    </message>
    <message>
        <source>{} says that it has {} elements of the kind {}; there is room for {}.</source>
        <translation>{} annonce {} éléments du type {} ; il y a place pour {}.</translation>
    </message>
    <message>
        <source>{}: a face uses normal {}; there are {}.</source>
        <translation>{} : une face utilise la normale {} ; il y en a {}.</translation>
    </message>
    <message>
        <source>{}: a face uses texture coordinate {}; there are {}.</source>
        <translation>{} : une face utilise la coordonnée de texture {} ; il y en a {}.</translation>
    </message>
    <message>
        <source>{}: a face uses vertex {}; there are {}.</source>
        <translation>{} : une face utilise le sommet {} ; il y en a {}.</translation>
    </message>
    <message>
        <source>{}: a surface has no positions of 32-bit floats, or other numbers of normals or texture coordinates.</source>
        <translation>{} : une surface n’a pas de positions en flottants de 32 bits, ou un autre nombre de normales ou de coordonnées de texture.</translation>
    </message>
    <message>
        <source>{}: its nodes are missing, nested more than {} deep or more than {}.</source>
        <translation>{} : ses nœuds manquent, sont imbriqués à plus de {} niveaux ou sont plus de {}.</translation>
    </message>
    <message>
        <source>{}: normal {} is not a finite vector.</source>
        <translation>{} : la normale {} n’est pas un vecteur fini.</translation>
    </message>
    <message>
        <source>{}: texture coordinate {} is not a finite pair of numbers.</source>
        <translation>{} : la coordonnée de texture {} n’est pas un couple de nombres finis.</translation>
    </message>
    <message>
        <source>{}: the numbers of a surface are missing, sparse or of another kind than they must be.</source>
        <translation>{} : les nombres d’une surface manquent, sont creux ou d’un autre type que celui qu’il faut.</translation>
    </message>
    <message>
        <source>{}: the numbers of a surface lie in no buffer, or are of no known type.</source>
        <translation>{} : les nombres d’une surface ne sont dans aucun tampon, ou d’aucun type connu.</translation>
    </message>
    <message>
        <source>{}: vertex {} lies at ({}, {}, {}); coordinates must be numbers of up to {}.</source>
        <translation>{} : le sommet {} est en ({}, {}, {}) ; les coordonnées doivent être des nombres jusqu’à {}.</translation>
    </message>
    <message>
        <source>&quot;&quot;, &quot;x&quot;, &quot;y&quot; or &quot;xy&quot;</source>
        <translation>&quot;&quot;, &quot;x&quot;, &quot;y&quot; ou &quot;xy&quot;</translation>
    </message>
    <message>
        <source>--shard {}: write it as I/N with I from 1 to N, as 3/8.</source>
        <translation>--shard {} : à écrire I/N, avec I de 1 à N, par exemple 3/8.</translation>
    </message>
    <message>
        <source>1 to {}</source>
        <translation>de 1 à {}</translation>
    </message>
    <message>
        <source>A compact set of {} tiles need not close over a border; choose a full set for outputs that wrap.</source>
        <translation>Un jeu compact de {} tuiles ne se raccorde pas forcément au bord ; choisissez un jeu complet pour les sorties qui se répètent.</translation>
    </message>
    <message>
        <source>An image of the result&apos;s size that the method begins with.</source>
        <translation>Une image de la taille du résultat, d’où part la méthode.</translation>
    </message>
    <message>
        <source>Blocks of {} px hold whole ones.</source>
        <translation>Des blocs de {} px en contiennent d’entiers.</translation>
    </message>
    <message>
        <source>Changes noise, or an initial image, from coarse to fine until its patches are distributed as the exemplar&apos;s are. New pixels rather than copies; keeps all the exemplar&apos;s patches in use, and mixes several exemplars by their weights.</source>
        <translation>Modifie un bruit ou une image de départ, du grossier au fin, jusqu’à ce que ses patchs soient répartis comme ceux de l’échantillon. Des pixels nouveaux plutôt que des copies ; emploie tous les patchs de l’échantillon et mélange plusieurs échantillons selon leurs poids.</translation>
    </message>
    <message>
        <source>Changing low frequencies</source>
        <translation>Modification des basses fréquences</translation>
    </message>
    <message>
        <source>Compact</source>
        <translation>Compact</translation>
    </message>
    <message>
        <source>Companion maps</source>
        <translation>Cartes associées</translation>
    </message>
    <message>
        <source>Cut-off</source>
        <translation>Coupure</translation>
    </message>
    <message>
        <source>Cutting tiles</source>
        <translation>Découpe des tuiles</translation>
    </message>
    <message>
        <source>Detail patch</source>
        <translation>Patch de détail</translation>
    </message>
    <message>
        <source>Deviation of the Gaussian that parts the bands: larger changes only what is slower, 0 changes everything.</source>
        <translation>Écart type de la gaussienne qui sépare les bandes : plus grand ne change que ce qui est plus lent, 0 change tout.</translation>
    </message>
    <message>
        <source>Deviation, {}</source>
        <translation>Écart, {}</translation>
    </message>
    <message>
        <source>Directions</source>
        <translation>Directions</translation>
    </message>
    <message>
        <source>Distance of patches</source>
        <translation>Distance des patchs</translation>
    </message>
    <message>
        <source>Drawing the tile set</source>
        <translation>Tracé du jeu de tuiles</translation>
    </message>
    <message>
        <source>Draws of samples</source>
        <translation>Tirages d’échantillons</translation>
    </message>
    <message>
        <source>Error of the worst cut</source>
        <translation>Erreur de la pire coupe</translation>
    </message>
    <message>
        <source>Error of the worst cut at which no more samples are drawn, over the error of unlike pixels: smaller searches longer.</source>
        <translation>Erreur de la pire coupe à partir de laquelle on ne tire plus d’échantillons, rapportée à celle de pixels dissemblables : plus petit cherche plus longtemps.</translation>
    </message>
    <message>
        <source>Full</source>
        <translation>Complet</translation>
    </message>
    <message>
        <source>Good enough</source>
        <translation>Assez bon</translation>
    </message>
    <message>
        <source>How often the samples are drawn again, at most, until the worst cut is good enough; the best are kept.</source>
        <translation>Combien de fois, au plus, les échantillons sont tirés à nouveau jusqu’à ce que la pire coupe soit assez bonne ; les meilleurs sont gardés.</translation>
    </message>
    <message>
        <source>Keeps the detail of the exemplar, or of an initial image, and draws the phase of its slow changes at random, so that stains and shades lie elsewhere. Suits metal and stone seen from afar; where detail follows the shades, as in wood, the two part.</source>
        <translation>Garde le détail du modèle ou d’une image initiale et tire au hasard la phase de ses variations lentes, de sorte que taches et ombres se trouvent ailleurs. Convient au métal et à la pierre vus de loin ; là où le détail suit les ombres, comme dans le bois, les deux se séparent.</translation>
    </message>
    <message>
        <source>Keeps the strength of each frequency of the exemplar and draws its phase at random. Instant, and without any repetition; suits fine-grained textures such as sand, plaster or cloth, and loses edges and objects.</source>
        <translation>Garde la force de chaque fréquence de l’échantillon et tire sa phase au hasard. Instantané et sans répétition ; convient aux textures fines comme le sable, l’enduit ou le tissu, perd contours et objets.</translation>
    </message>
    <message>
        <source>Laying tiles</source>
        <translation>Pose des tuiles</translation>
    </message>
    <message>
        <source>Maps of the exemplar&apos;s size, such as normals or heights, that get the result&apos;s layout.</source>
        <translation>Des cartes de la taille de l’échantillon, comme des normales ou des hauteurs, qui reçoivent la disposition du résultat.</translation>
    </message>
    <message>
        <source>Mask</source>
        <translation>Masque</translation>
    </message>
    <message>
        <source>Matching patches</source>
        <translation>Appariement des patchs</translation>
    </message>
    <message>
        <source>Most rounds for each patch size on each scale: more join better, but take longer.</source>
        <translation>Au plus autant par taille de patch et par échelle : davantage raccorde mieux, mais prend plus de temps.</translation>
    </message>
    <message>
        <source>Most rounds on each scale but the finest: more join better, but take longer.</source>
        <translation>Au plus autant à chaque échelle sauf la plus fine : davantage raccorde mieux, mais prend plus de temps.</translation>
    </message>
    <message>
        <source>Most rounds on the finest scale, where most of the time is spent.</source>
        <translation>Au plus autant à l’échelle la plus fine, où passe l’essentiel du temps.</translation>
    </message>
    <message>
        <source>Most scales, each half the size of the one before: more keep larger structures.</source>
        <translation>Au plus autant, chacune deux fois plus petite que la précédente : davantage garde de plus grandes structures.</translation>
    </message>
    <message>
        <source>Near-regular</source>
        <translation>Presque régulier</translation>
    </message>
    <message>
        <source>Networks</source>
        <translation>Réseaux</translation>
    </message>
    <message>
        <source>Occurrence {}</source>
        <translation>Occurrence {}</translation>
    </message>
    <message>
        <source>One slope over the whole</source>
        <translation>Une pente sur l’ensemble</translation>
    </message>
    <message>
        <source>Optimisation</source>
        <translation>Optimisation</translation>
    </message>
    <message>
        <source>Patch distribution</source>
        <translation>Distribution des patchs</translation>
    </message>
    <message>
        <source>Pixel by pixel</source>
        <translation>Pixel par pixel</translation>
    </message>
    <message>
        <source>Pixels of the exemplar where it is black are never used.</source>
        <translation>Les pixels de l’échantillon où elle est noire ne servent jamais.</translation>
    </message>
    <message>
        <source>Position map</source>
        <translation>Carte de positions</translation>
    </message>
    <message>
        <source>Random directions along which patches are compared in one iteration: more make each iteration surer and longer.</source>
        <translation>Directions aléatoires selon lesquelles les patchs sont comparés à chaque itération : davantage la rend plus sûre et plus longue.</translation>
    </message>
    <message>
        <source>Random low frequencies</source>
        <translation>Basses fréquences aléatoires</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Résultat</translation>
    </message>
    <message>
        <source>Scale 1/{}</source>
        <translation>Échelle 1/{}</translation>
    </message>
    <message>
        <source>Scale 1/{}, patches of {} px</source>
        <translation>Échelle 1/{}, patchs de {} px</translation>
    </message>
    <message>
        <source>Set</source>
        <translation>Jeu</translation>
    </message>
    <message>
        <source>Side of a tile: larger repeats less and keeps larger structures, smaller has more edges.</source>
        <translation>Côté d’une tuile : plus grand se répète moins et garde de plus grandes structures, plus petit a plus de bords.</translation>
    </message>
    <message>
        <source>Side of the compared patches at each scale: larger keeps larger structures whole and takes longer.</source>
        <translation>Côté des patchs comparés à chaque échelle : plus grand garde entières de plus grandes structures et prend plus de temps.</translation>
    </message>
    <message>
        <source>Solids</source>
        <translation>Solides</translation>
    </message>
    <message>
        <source>Sparse</source>
        <translation>Parcimonie</translation>
    </message>
    <message>
        <source>The checkpoint is of a run with other settings or exemplars; start the run again.</source>
        <translation>Le point de reprise vient d’un calcul avec d’autres réglages ou échantillons ; recommencez le calcul.</translation>
    </message>
    <message>
        <source>The earlier result in {} is left out: {}</source>
        <translation>Le résultat antérieur dans {} est laissé de côté : {}</translation>
    </message>
    <message>
        <source>The exemplar&apos;s pixel that each pixel of the result was copied from.</source>
        <translation>Le pixel de l’échantillon dont chaque pixel du résultat a été copié.</translation>
    </message>
    <message>
        <source>The four corners of the rectification must go clockwise from the top left around an area without a dent.</source>
        <translation>Les quatre coins du redressement doivent entourer dans le sens horaire, depuis le haut à gauche, une surface sans creux.</translation>
    </message>
    <message>
        <source>The image to learn from.</source>
        <translation>L’image dont on apprend.</translation>
    </message>
    <message>
        <source>The input {} of {} takes {}.</source>
        <translation>L’entrée {} de {} prend : {}.</translation>
    </message>
    <message>
        <source>The lattice&apos;s tile of {:.0f} × {:.0f} px is larger than the blocks of {} px, so new ones are pieced together from parts of several. {}</source>
        <translation>La maille du réseau, de {} × {} px, dépasse les blocs de {} px : les nouvelles sont faites de morceaux de plusieurs. {}</translation>
    </message>
    <message>
        <source>The lattice&apos;s vectors ({}, {}) and ({}, {}) px do not span a tile; give two that do not lie on one line.</source>
        <translation>Les vecteurs ({}, {}) et ({}, {}) px du réseau ne forment pas de maille ; donnez-en deux qui ne soient pas alignés.</translation>
    </message>
    <message>
        <source>The light in {} varies so much that patches would show, so it was evened out; flatten=no keeps it.</source>
        <translation>La lumière de {} varie tant d’un endroit à l’autre que des pièces se verraient ; elle a donc été égalisée. flatten=no la garde.</translation>
    </message>
    <message>
        <source>The map needs one image for each exemplar that it was made from: {}, not {}.</source>
        <translation>La carte demande une image par échantillon dont elle est issue : {}, et non {}.</translation>
    </message>
    <message>
        <source>The mask leaves no whole sample of {} px for tiles of {} px; choose smaller tiles or mask less.</source>
        <translation>Le masque ne laisse aucun échantillon entier de {} px pour des tuiles de {} px ; choisissez des tuiles plus petites ou masquez moins.</translation>
    </message>
    <message>
        <source>The method treats all exemplars alike, so their weights had no effect.</source>
        <translation>La méthode prend tous les modèles de la même façon : leurs poids n’ont rien changé.</translation>
    </message>
    <message>
        <source>The name {} holds ${}, which stands for nothing here; use {}.</source>
        <translation>Le nom {} contient ${}, qui ne désigne rien ici ; utilisez {}.</translation>
    </message>
    <message>
        <source>The picture for “{}” is {} × {} px, but {} is {} × {} px; it must be of that size.</source>
        <translation>L’image pour « {} » fait {} × {} px, mais {} fait {} × {} px ; elle doit avoir cette taille.</translation>
    </message>
    <message>
        <source>The rows, {:.0f} px apart, are larger than the blocks of {} px, so new ones are pieced together from parts of several. {}</source>
        <translation>Les rangées, distantes de {} px, dépassent les blocs de {} px : les nouvelles sont faites de morceaux de plusieurs. {}</translation>
    </message>
    <message>
        <source>The run was stopped before it knew where its pixels come from, so there are no companion maps.</source>
        <translation>Le calcul a été arrêté avant de savoir d’où viennent ses pixels ; il n’y a donc pas de cartes associées.</translation>
    </message>
    <message>
        <source>The texture that was made.</source>
        <translation>La texture obtenue.</translation>
    </message>
    <message>
        <source>The work ended for an unknown reason; try again.</source>
        <translation>Le travail s’est terminé pour une raison inconnue ; réessayez.</translation>
    </message>
    <message>
        <source>The {} has an unknown field {}; the known ones are {}.</source>
        <translation>{} : le champ {} est inconnu ; les champs connus sont {}.</translation>
    </message>
    <message>
        <source>The {} {} is {} × {} px, but {} is {} × {} px; they must be the same size.</source>
        <translation>{1} ({0}) fait {2} × {3} px, mais {4} fait {5} × {6} px ; ils doivent être pareils.</translation>
    </message>
    <message>
        <source>There is no colour space {}; choose one of {}.</source>
        <translation>Il n’y a pas d’espace de couleur {} ; choisissez l’un de {}.</translation>
    </message>
    <message>
        <source>There is no export preset {}; choose one of {}.</source>
        <translation>Il n’y a pas de préréglage d’export {} ; choisissez l’un de {}.</translation>
    </message>
    <message>
        <source>There is no kind of map {}; the kinds are {}.</source>
        <translation>Il n’y a pas de type de carte {} ; les types sont {}.</translation>
    </message>
    <message>
        <source>There is no method {}; the methods are {}.</source>
        <translation>Il n’y a pas de méthode {} ; les méthodes sont {}.</translation>
    </message>
    <message>
        <source>There is not enough memory for this; try a smaller output.</source>
        <translation>La mémoire n’y suffit pas ; essayez une sortie plus petite.</translation>
    </message>
    <message>
        <source>Tile size</source>
        <translation>Taille des tuiles</translation>
    </message>
    <message>
        <source>Tiles</source>
        <translation>Tuiles</translation>
    </message>
    <message>
        <source>Tiles of {} px take samples of {} × {} px, but {} is {} × {} px; choose smaller tiles or less overlap.</source>
        <translation>Des tuiles de {} px demandent des échantillons de {} × {} px, mais {} fait {} × {} px ; choisissez des tuiles plus petites ou moins de recouvrement.</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Outils</translation>
    </message>
    <message>
        <source>Tries</source>
        <translation>Essais</translation>
    </message>
    <message>
        <source>Wang tiles</source>
        <translation>Tuiles de Wang</translation>
    </message>
    <message>
        <source>Where the output has another size and there is no initial image, detail is quilted from patches of this side: larger keeps larger structures whole.</source>
        <translation>Là où la sortie a une autre taille et qu’il n’y a pas d’image initiale, le détail est assemblé à partir de patchs de ce côté : plus grand garde entières de plus grandes structures.</translation>
    </message>
    <message>
        <source>Works on the periodic component, without which the borders draw horizontal and vertical streaks. Outputs that wrap always need it.</source>
        <translation>Travaille sur la composante périodique, sans laquelle les bords tracent des traînées horizontales et verticales. Les sorties qui se répètent en ont toujours besoin.</translation>
    </message>
    <message>
        <source>a list of at least one method</source>
        <translation>une liste d’au moins une méthode</translation>
    </message>
    <message>
        <source>a list of {} to {}</source>
        <translation>une liste de {} à {} éléments</translation>
    </message>
    <message>
        <source>a mask</source>
        <translation>un masque</translation>
    </message>
    <message>
        <source>a mesh</source>
        <translation>un maillage</translation>
    </message>
    <message>
        <source>a model</source>
        <translation>un modèle</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>un nombre</translation>
    </message>
    <message>
        <source>a number, text, true or false</source>
        <translation>un nombre, un texte, true ou false</translation>
    </message>
    <message>
        <source>a position map</source>
        <translation>une carte de position</translation>
    </message>
    <message>
        <source>a volume</source>
        <translation>un volume</translation>
    </message>
    <message>
        <source>a whole number from 0 to 18446744073709551615</source>
        <translation>un entier de 0 à 18446744073709551615</translation>
    </message>
    <message>
        <source>a whole number that is not too large</source>
        <translation>un entier qui ne soit pas trop grand</translation>
    </message>
    <message>
        <source>an image</source>
        <translation>une image</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>un objet</translation>
    </message>
    <message>
        <source>any number</source>
        <translation>un nombre quelconque</translation>
    </message>
    <message>
        <source>any whole number</source>
        <translation>un entier quelconque</translation>
    </message>
    <message>
        <source>batch</source>
        <translation>lot</translation>
    </message>
    <message>
        <source>companion</source>
        <translation>carte associée</translation>
    </message>
    <message>
        <source>deep</source>
        <translation>deep</translation>
    </message>
    <message>
        <source>entry</source>
        <translation>entrée</translation>
    </message>
    <message>
        <source>it was made by another version.</source>
        <translation>il a été fait par une autre version.</translation>
    </message>
    <message>
        <source>its entry is damaged.</source>
        <translation>son entrée est endommagée.</translation>
    </message>
    <message>
        <source>its kind of map is not known.</source>
        <translation>la nature de sa carte est inconnue.</translation>
    </message>
    <message>
        <source>mask</source>
        <translation>masque</translation>
    </message>
    <message>
        <source>on or off</source>
        <translation>activé ou désactivé</translation>
    </message>
    <message>
        <source>one of {}</source>
        <translation>l’un de {}</translation>
    </message>
    <message>
        <source>preset</source>
        <translation>préréglage</translation>
    </message>
    <message>
        <source>session</source>
        <translation>session</translation>
    </message>
    <message>
        <source>text</source>
        <translation>un texte</translation>
    </message>
    <message>
        <source>the disk may be full</source>
        <translation>le disque est peut-être plein</translation>
    </message>
    <message>
        <source>the name of a file</source>
        <translation>le nom d’un fichier</translation>
    </message>
    <message>
        <source>the output</source>
        <translation>la sortie</translation>
    </message>
    <message>
        <source>volume</source>
        <translation>volume</translation>
    </message>
    <message>
        <source>{} (other ones)</source>
        <translation>{} (d’autres)</translation>
    </message>
    <message>
        <source>{} = {}: {} goes from {}.</source>
        <translation>{} = {} : {} va de {}.</translation>
    </message>
    <message>
        <source>{} = {}: {} is one of {}.</source>
        <translation>{} = {} : {} est l’un de {}.</translation>
    </message>
    <message>
        <source>{} = {}: {} is {}.</source>
        <translation>{} = {} : {} est {}.</translation>
    </message>
    <message>
        <source>{} Did you mean {}?</source>
        <translation>{} Vouliez-vous dire {} ?</translation>
    </message>
    <message>
        <source>{} and {}</source>
        <translation>{} et {}</translation>
    </message>
    <message>
        <source>{} and {} have different numbers of channels, {} and {}; all exemplars need the same.</source>
        <translation>{} et {} n’ont pas le même nombre de canaux, {} et {} ; tous les échantillons en veulent autant.</translation>
    </message>
    <message>
        <source>{} and {} have different numbers of companion maps, {} and {}; every exemplar needs the same ones.</source>
        <translation>{} et {} n’ont pas le même nombre de cartes associées, {} et {} ; chaque échantillon veut les mêmes.</translation>
    </message>
    <message>
        <source>{} cannot be written: the name ends in nothing that names a format; Texloom writes .png, .jpg, .tif, .exr and .hdr.</source>
        <translation>{} ne peut être écrit : la fin du nom n’indique aucun format ; Texloom écrit .png, .jpg, .tif, .exr et .hdr.</translation>
    </message>
    <message>
        <source>{} copies no pixels, so it has no position map.</source>
        <translation>{} ne copie pas de pixels et n’a donc pas de carte de position.</translation>
    </message>
    <message>
        <source>{} has no input {}.</source>
        <translation>{} n’a pas d’entrée {}.</translation>
    </message>
    <message>
        <source>{} has no input {}; it takes {}.</source>
        <translation>{} n’a pas d’entrée {} ; il y a {}.</translation>
    </message>
    <message>
        <source>{} has no parameter {}; it has {}.</source>
        <translation>{} n’a pas de paramètre {} ; il y a {}.</translation>
    </message>
    <message>
        <source>{} holds {} values that are not finite numbers, the first at pixel ({}, {}); save it without them.</source>
        <translation>{} contient {} valeurs qui ne sont pas des nombres finis, la première au pixel ({}, {}) ; Texloom en veut de finis.</translation>
    </message>
    <message>
        <source>{} is a checkpoint of format {}; this Texloom ({}) reads format {}. Start the run again.</source>
        <translation>{} est un point de reprise au format {} ; ce Texloom ({}) lit le format {}. Recommencez le calcul.</translation>
    </message>
    <message>
        <source>{} is a folder, not an image.</source>
        <translation>{} est un dossier, non une image.</translation>
    </message>
    <message>
        <source>{} is longer than {}, too long for a file of this kind.</source>
        <translation>{} dépasse {}, trop long pour un fichier de cette sorte.</translation>
    </message>
    <message>
        <source>{} is not a checkpoint, or it is damaged; start the run again.</source>
        <translation>{} n’est pas un point de reprise ou est endommagé ; recommencez le calcul.</translation>
    </message>
    <message>
        <source>{} is not a position map: an STMap has 2 to 4 channels of 32-bit floats, but this file has {} of {}.</source>
        <translation>{} n’est pas une carte de position : une STMap a 2 à 4 canaux flottants de 32 bits, ce fichier {} de {}.</translation>
    </message>
    <message>
        <source>{} is not a position map: as a PNG it has 3 channels of 16 bits, but this file has {} of {}.</source>
        <translation>{} n’est pas une carte de position : en PNG elle a 3 canaux de 16 bits, ce fichier {} de {}.</translation>
    </message>
    <message>
        <source>{} is not an ordinary file, so it is not an image.</source>
        <translation>{} n’est pas un fichier ordinaire ni une image.</translation>
    </message>
    <message>
        <source>{} is not part of this build. {}</source>
        <translation>{} ne fait pas partie de cette version. {}</translation>
    </message>
    <message>
        <source>{} names an exemplar of {} × {} px; sides go from 1 to {} px.</source>
        <translation>{} annonce un modèle de {} × {} px ; les côtés vont de 1 à {} px.</translation>
    </message>
    <message>
        <source>{} needs {} for its input {}, but {} were given.</source>
        <translation>{} en demande {} pour son entrée {}, mais {} ont été donnés.</translation>
    </message>
    <message>
        <source>{} takes no exemplar.</source>
        <translation>{} ne prend pas d’échantillon.</translation>
    </message>
    <message>
        <source>{} uses nothing that {} makes, so it cannot follow it.</source>
        <translation>{} ne reprend rien de ce que fait {} et ne peut donc le suivre.</translation>
    </message>
    <message>
        <source>{} takes {} for its input {}, but {} were given.</source>
        <translation>{} en prend {} pour son entrée {}, mais {} ont été donnés.</translation>
    </message>
    <message>
        <source>{} to {}</source>
        <translation>{} à {}</translation>
    </message>
    <message>
        <source>{} to {} {}</source>
        <translation>{} à {} {}</translation>
    </message>
    <message>
        <source>{} was not straightened, since too little of it would be left.</source>
        <translation>{} n’a pas été redressé : il en resterait trop peu.</translation>
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
        <translation>{} : {}</translation>
    </message>
    <message>
        <source>“Regular tile” repeats whole ones.</source>
        <translation>« Tuile régulière » en répète d’entières.</translation>
    </message>
    <message>
        <source>The worst cut&apos;s error is {:.2f} of that of unlike pixels, more than the {} wished for; more tries, larger tiles or fewer colours may help.</source>
        <translation>L’erreur de la pire coupe vaut {} de celle de pixels sans rapport, plus que les {} voulus ; plus d’essais, de plus grandes tuiles ou moins de couleurs peuvent aider.</translation>
    </message>
    <message>
        <source>checkpoint</source>
        <translation>point de reprise</translation>
    </message>
    <message>
        <source>{} is damaged: an entry of its header says that it has {} bytes, but the file has {}.</source>
        <translation>{} est endommagé : une entrée de l’en-tête dit avoir {} octets, mais le fichier en a {}.</translation>
    </message>
    <message>
        <source>A picture of the exemplar to compare with the target, such as its height or its labels; without one, the blurred luminance of both is compared.</source>
        <translation>Une image de l’échantillon à comparer à la cible, comme sa hauteur ou ses étiquettes ; sans elle, les luminances floutées des deux sont comparées.</translation>
    </message>
    <message>
        <source>Blur</source>
        <translation>Flou</translation>
    </message>
    <message>
        <source>Correspondence</source>
        <translation>Correspondance</translation>
    </message>
    <message>
        <source>Gives the target&apos;s luminance the mean and the contrast of the exemplar&apos;s, so that dark targets, too, find patches of all tones.</source>
        <translation>Donne à la luminance de la cible la moyenne et le contraste de celle de l’échantillon, pour que les cibles sombres trouvent aussi des morceaux de tous les tons.</translation>
    </message>
    <message>
        <source>How much luminance is blurred before it is compared: larger heeds only broad light and dark.</source>
        <translation>Combien la luminance est floutée avant la comparaison : plus grand ne suit que les larges clairs et sombres.</translation>
    </message>
    <message>
        <source>How much the joins count in the first pass; the target has the rest. 1 is plain quilting.</source>
        <translation>Combien comptent les raccords à la première passe ; le reste revient à la cible. 1 donne un quilting ordinaire.</translation>
    </message>
    <message>
        <source>How much the joins, and the pass before, count in the last pass; the target has the rest.</source>
        <translation>Combien comptent les raccords et la passe précédente à la dernière passe ; le reste revient à la cible.</translation>
    </message>
    <message>
        <source>How often the output is quilted over, each time with smaller patches: more follow the target more closely.</source>
        <translation>Combien de fois la sortie est recousue, chaque fois avec des morceaux plus petits : davantage suivent mieux la cible.</translation>
    </message>
    <message>
        <source>Match tones</source>
        <translation>Accorder les tons</translation>
    </message>
    <message>
        <source>Passes</source>
        <translation>Passes</translation>
    </message>
    <message>
        <source>Preparing the correspondence</source>
        <translation>Préparation de la correspondance</translation>
    </message>
    <message>
        <source>Shows a target picture in the exemplar&apos;s material: patches are quilted that follow the target&apos;s light and dark, with smaller patches in each pass.</source>
        <translation>Montre une image cible dans la matière de l’échantillon : des morceaux sont cousus qui suivent les clairs et les sombres de la cible, plus petits à chaque passe.</translation>
    </message>
    <message>
        <source>Side of the patches in the first pass; each further pass takes two thirds of it. Larger shows more of the material, smaller more of the target.</source>
        <translation>Côté des morceaux à la première passe ; chaque passe suivante en prend les deux tiers. Plus grand montre mieux la matière, plus petit la cible.</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Cible</translation>
    </message>
    <message>
        <source>Texture in the first pass</source>
        <translation>Texture à la première passe</translation>
    </message>
    <message>
        <source>Texture in the last pass</source>
        <translation>Texture à la dernière passe</translation>
    </message>
    <message>
        <source>Texture transfer</source>
        <translation>Transfert de texture</translation>
    </message>
    <message>
        <source>The picture that the result is to look like from afar, of the output&apos;s size.</source>
        <translation>L’image à laquelle le résultat doit ressembler de loin, de la taille de la sortie.</translation>
    </message>
    <message>
        <source>{} has no picture that corresponds to the target, but another exemplar has; give one for each or for none.</source>
        <translation>{} n’a pas d’image qui corresponde à la cible, mais un autre échantillon en a une ; donnez-en une à chacun ou à aucun.</translation>
    </message>
    <message>
        <source>An edit is empty; write it as tool=value, with one of {}.</source>
        <translation>Une modification est vide ; écrivez-la sous la forme outil=valeur, avec l’un de {}.</translation>
    </message>
    <message>
        <source>An edit names no tool; those that edit are {}.</source>
        <translation>Une modification ne nomme aucun outil ; ceux qui modifient sont {}.</translation>
    </message>
    <message>
        <source>An edit with {} names no tool that is known here; those that edit are {}.</source>
        <translation>Une modification avec {} ne nomme aucun outil connu ici ; ceux qui modifient sont {}.</translation>
    </message>
    <message>
        <source>An output of {} × {} px is made in strips of {} rows, without position maps, companion maps or anything else beside it; choose a region or a smaller size to get those.</source>
        <translation>Une sortie de {} × {} px est faite par bandes de {} lignes, sans cartes de positions, cartes associées ni rien d&apos;autre à côté ; choisissez une région ou une taille plus petite pour les obtenir.</translation>
    </message>
    <message>
        <source>An output of {} × {} px would need {} of memory, more than {}; choose a smaller size.</source>
        <translation>Une sortie de {} × {} px demanderait {} de mémoire, plus que {} ; choisissez une taille plus petite.</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Zone</translation>
    </message>
    <message>
        <source>As the file&apos;s tags say</source>
        <translation>Comme le disent les balises du fichier</translation>
    </message>
    <message>
        <source>As they are (RGB)</source>
        <translation>Telles quelles (RVB)</translation>
    </message>
    <message>
        <source>Band</source>
        <translation>Bande</translation>
    </message>
    <message>
        <source>Bottom left</source>
        <translation>En bas à gauche</translation>
    </message>
    <message>
        <source>Bottom right</source>
        <translation>En bas à droite</translation>
    </message>
    <message>
        <source>Circular</source>
        <translation>Circulaire</translation>
    </message>
    <message>
        <source>Clockwise, in degrees.</source>
        <translation>Dans le sens horaire, en degrés.</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Couleurs</translation>
    </message>
    <message>
        <source>Corners</source>
        <translation>Coins</translation>
    </message>
    <message>
        <source>Cosine axes (DCT)</source>
        <translation>Axes cosinus (DCT)</translation>
    </message>
    <message>
        <source>Crop</source>
        <translation>Recadrer</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Courbe</translation>
    </message>
    <message>
        <source>Cuts where the images differ least.</source>
        <translation>Coupe là où les images diffèrent le moins.</translation>
    </message>
    <message>
        <source>Deforms both images until they agree; draws lines from the middle to the border.</source>
        <translation>Déforme les deux images jusqu’à ce qu’elles concordent ; trace des lignes du milieu au bord.</translation>
    </message>
    <message>
        <source>Deforms both images until they agree; fades out evenly.</source>
        <translation>Déforme les deux images jusqu’à ce qu’elles concordent ; s’estompe régulièrement.</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Direction</translation>
    </message>
    <message>
        <source>Fading</source>
        <translation>Atténuation</translation>
    </message>
    <message>
        <source>Horizontal</source>
        <translation>Horizontale</translation>
    </message>
    <message>
        <source>How far from the curve, on either side, pixels may change: up to half the images&apos; shorter side.</source>
        <translation>Jusqu’où, de part et d’autre de la courbe, les pixels peuvent changer : au plus la moitié du petit côté des images.</translation>
    </message>
    <message>
        <source>How midway blending fades out towards the border of the band.</source>
        <translation>Comment le fondu midway s’atténue vers le bord de la bande.</translation>
    </message>
    <message>
        <source>How much of the unevenness is taken out; 1 is all.</source>
        <translation>Quelle part de l’inégalité est retirée ; 1 : tout.</translation>
    </message>
    <message>
        <source>How often the light may bend over the exemplar: 1 is a plain slope.</source>
        <translation>Combien de fois la lumière peut se courber sur l’échantillon : 1 est une simple pente.</translation>
    </message>
    <message>
        <source>How the images meet.</source>
        <translation>Comment les images se rejoignent.</translation>
    </message>
    <message>
        <source>Joins the gradients of both images.</source>
        <translation>Joint les gradients des deux images.</translation>
    </message>
    <message>
        <source>Joins two images along a curve, so that the seam does not show.</source>
        <translation>Joint deux images le long d’une courbe sans que la couture se voie.</translation>
    </message>
    <message>
        <source>Keeps a rectangle of the exemplar.</source>
        <translation>Garde un rectangle de l’échantillon.</translation>
    </message>
    <message>
        <source>Leaves the images as they are, to compare with.</source>
        <translation>Laisse les images telles quelles, pour comparer.</translation>
    </message>
    <message>
        <source>Left and upper edge, width and height, in the exemplar as the edits before it left it.</source>
        <translation>Bord gauche et bord supérieur, largeur et hauteur, dans l’échantillon après les modifications précédentes.</translation>
    </message>
    <message>
        <source>Left to right</source>
        <translation>De gauche à droite</translation>
    </message>
    <message>
        <source>Makes a rectangle of a surface that was photographed at a slant.</source>
        <translation>Fait un rectangle d’une surface photographiée de biais.</translation>
    </message>
    <message>
        <source>Midway, linear</source>
        <translation>Midway, linéaire</translation>
    </message>
    <message>
        <source>Midway, progressive</source>
        <translation>Midway, progressif</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>Miroir</translation>
    </message>
    <message>
        <source>Mirror left to right</source>
        <translation>Retourner gauche-droite</translation>
    </message>
    <message>
        <source>Mirror top to bottom</source>
        <translation>Retourner haut-bas</translation>
    </message>
    <message>
        <source>Not blended</source>
        <translation>Sans fondu</translation>
    </message>
    <message>
        <source>Of the rectangle; if not given, as long as the longer of opposite sides.</source>
        <translation>Du rectangle ; sans indication, aussi long que le plus grand des côtés opposés.</translation>
    </message>
    <message>
        <source>Poisson editing</source>
        <translation>Édition de Poisson</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Principal axes (PCA)</source>
        <translation>Axes principaux (ACP)</translation>
    </message>
    <message>
        <source>Put the corners on four that are a rectangle in reality.</source>
        <translation>Placez les coins sur quatre points qui forment un rectangle en réalité.</translation>
    </message>
    <message>
        <source>Rectify</source>
        <translation>Redresser</translation>
    </message>
    <message>
        <source>Swaps left and right, or top and bottom.</source>
        <translation>Échange la gauche et la droite, ou le haut et le bas.</translation>
    </message>
    <message>
        <source>Takes slow changes of brightness out of the colours, so that parts from light and dark places match.</source>
        <translation>Ôte les lentes variations de luminosité des couleurs, pour que les parties claires et sombres s’accordent.</translation>
    </message>
    <message>
        <source>The colour axes that midway blending treats one by one.</source>
        <translation>Les axes de couleur que le fondu midway traite un à un.</translation>
    </message>
    <message>
        <source>The edit &quot;{}&quot; says {} twice.</source>
        <translation>La modification « {} » indique {} deux fois.</translation>
    </message>
    <message>
        <source>The first image lies above, left of or outside the curve; circles go around the bottom right corner.</source>
        <translation>La première image est au-dessus, à gauche ou en dehors de la courbe ; les cercles entourent le coin inférieur droit.</translation>
    </message>
    <message>
        <source>The folder {} cannot be made; check that there is room.</source>
        <translation>Le dossier {} ne peut pas être créé ; vérifiez qu’il y a de la place.</translation>
    </message>
    <message>
        <source>The input {} of {} takes a model of its own kind, and was given one of the kind {}.</source>
        <translation>L&apos;entrée {} de {} prend un modèle de son propre genre et en a reçu un du genre {}.</translation>
    </message>
    <message>
        <source>The input {} of {} was given, and {} makes it, too; leave one of them out.</source>
        <translation>L&apos;entrée {} de {} a été donnée, et {} la produit aussi ; omettez l&apos;une des deux.</translation>
    </message>
    <message>
        <source>The model is of the kind {}; one of the kind {} is needed.</source>
        <translation>Le modèle est du genre {} ; il en faut un du genre {}.</translation>
    </message>
    <message>
        <source>The result has no output {}.</source>
        <translation>Le résultat n&apos;a pas de sortie {}.</translation>
    </message>
    <message>
        <source>The {} says {} twice in one place; only one of them can hold.</source>
        <translation>{0} : {1} figure deux fois au même endroit ; un seul peut valoir.</translation>
    </message>
    <message>
        <source>The {} would replace {}, which Texloom did not write; name another file, or allow it with --overwrite.</source>
        <translation>{0} remplacerait {1}, que Texloom n&apos;a pas écrit ; nommez un autre fichier, ou permettez-le avec --overwrite.</translation>
    </message>
    <message>
        <source>The {} {} and the {} {} are the same file; name another one.</source>
        <translation>{0} {1} et {2} {3} sont le même fichier ; nommez-en un autre.</translation>
    </message>
    <message>
        <source>There is no tool {}; the tools are {}.</source>
        <translation>Il n’y a pas d’outil {} ; les outils sont {}.</translation>
    </message>
    <message>
        <source>There is not enough memory to take up an image: {}.</source>
        <translation>La mémoire ne suffit pas pour recevoir une image : {}.</translation>
    </message>
    <message>
        <source>There is nothing of the kind {}; there are {}.</source>
        <translation>Il n&apos;y a rien du genre {} ; il y a {}.</translation>
    </message>
    <message>
        <source>Top left</source>
        <translation>En haut à gauche</translation>
    </message>
    <message>
        <source>Top right</source>
        <translation>En haut à droite</translation>
    </message>
    <message>
        <source>Top to bottom</source>
        <translation>De haut en bas</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Tourner</translation>
    </message>
    <message>
        <source>Turn left by 90°</source>
        <translation>Tourner de 90° à gauche</translation>
    </message>
    <message>
        <source>Turn right by 90°</source>
        <translation>Tourner de 90° à droite</translation>
    </message>
    <message>
        <source>Turns the exemplar clockwise. Quarter turns move pixels as they are; other angles keep the largest upright rectangle inside.</source>
        <translation>Tourne l’échantillon dans le sens horaire. Les quarts de tour déplacent les pixels tels quels ; les autres angles gardent le plus grand rectangle droit à l’intérieur.</translation>
    </message>
    <message>
        <source>Vertical</source>
        <translation>Verticale</translation>
    </message>
    <message>
        <source>What the light is taken to be: what a wide window sees, or a low polynomial.</source>
        <translation>Ce que l’on prend pour la lumière : ce que voit une large fenêtre, ou un polynôme de bas degré.</translation>
    </message>
    <message>
        <source>Where the curve lies, from 0 (top, left, the whole circle) to 1.</source>
        <translation>Où se trouve la courbe, de 0 (haut, gauche, cercle entier) à 1.</translation>
    </message>
    <message>
        <source>Which sides change places.</source>
        <translation>Quels côtés échangent leurs places.</translation>
    </message>
    <message>
        <source>Width of the window that finds the light, in shares of the shorter side: larger leaves more of the texture&apos;s own shades.</source>
        <translation>Largeur de la fenêtre qui trouve la lumière, en parts du petit côté : plus laisse davantage des nuances propres à la texture.</translation>
    </message>
    <message>
        <source>a profile</source>
        <translation>un profil</translation>
    </message>
    <message>
        <source>a source of the result</source>
        <translation>une source du résultat</translation>
    </message>
    <message>
        <source>bytes in hexadecimal</source>
        <translation>des octets en hexadécimal</translation>
    </message>
    <message>
        <source>bytes in hexadecimal, two digits each</source>
        <translation>des octets en hexadécimal, deux chiffres pour chacun</translation>
    </message>
    <message>
        <source>gamma {:.3g}</source>
        <translation>gamma {:.3g}</translation>
    </message>
    <message>
        <source>gamma {:.3g} and primaries of its own</source>
        <translation>gamma {:.3g} et primaires propres</translation>
    </message>
    <message>
        <source>primaries of its own</source>
        <translation>primaires propres</translation>
    </message>
    <message>
        <source>the codes {}-{}-{}-{} of cICP</source>
        <translation>les codes {}-{}-{}-{} de cICP</translation>
    </message>
    <message>
        <source>text without a zero byte</source>
        <translation>un texte sans octet nul</translation>
    </message>
    <message>
        <source>the profile “{}”</source>
        <translation>le profil « {} »</translation>
    </message>
    <message>
        <source>the {} that are free</source>
        <translation>les {} qui sont libres</translation>
    </message>
    <message>
        <source>the {} that it may take</source>
        <translation>les {} qui sont permis</translation>
    </message>
    <message>
        <source>the {} that the limit of {} leaves</source>
        <translation>les {} que laisse la limite de {}</translation>
    </message>
    <message>
        <source>width,height, each {} to {} px</source>
        <translation>largeur,hauteur, de {} à {} px chacune</translation>
    </message>
    <message>
        <source>x,y,width,height in whole px</source>
        <translation>x,y,largeur,hauteur en px entiers</translation>
    </message>
    <message>
        <source>{} = {}: this is no number in decimal digits, without spaces; {}: {}.</source>
        <translation>{} = {} : ce n&apos;est pas un nombre en chiffres décimaux, sans espaces ; {} : {}.</translation>
    </message>
    <message>
        <source>{} = {}: this is not a whole number; {}: {}.</source>
        <translation>{} = {} : ce n&apos;est pas un nombre entier ; {} : {}.</translation>
    </message>
    <message>
        <source>{} = {}: this number is too large, or too near 0, to be held; {}: {}.</source>
        <translation>{} = {} : ce nombre est trop grand, ou trop près de 0, pour être représenté ; {} : {}.</translation>
    </message>
    <message>
        <source>{} cannot be read: its decoder broke down; the file is damaged, or of a kind that it does not know. Save it again with another program.</source>
        <translation>{} ne peut pas être lu : son décodeur s&apos;est arrêté net ; le fichier est abîmé, ou d&apos;une sorte qu&apos;il ne connaît pas. Enregistrez-le de nouveau avec un autre programme.</translation>
    </message>
    <message>
        <source>{} cannot be written: it is no ordinary file.</source>
        <translation>{} ne peut pas être écrit : ce n&apos;est pas un fichier ordinaire.</translation>
    </message>
    <message>
        <source>{} carries {}, which Texloom cannot convert; its colours are taken as {}.</source>
        <translation>{} porte {}, que Texloom ne sait pas convertir ; ses couleurs sont prises pour {}.</translation>
    </message>
    <message>
        <source>{} gives no output {}; it gives nothing beside its picture and map.</source>
        <translation>{} n&apos;a pas de sortie {} ; en dehors de l&apos;image et de la carte, il n&apos;y a rien.</translation>
    </message>
    <message>
        <source>{} gives no output {}; there are {}.</source>
        <translation>{} n&apos;a pas de sortie {} ; il y a {}.</translation>
    </message>
    <message>
        <source>{} has no layer {}; all that it holds is one picture.</source>
        <translation>{} n&apos;a pas de calque {} ; le fichier ne contient qu&apos;une image.</translation>
    </message>
    <message>
        <source>{} has no layer {}; there is {}.</source>
        <translation>{} n&apos;a pas de calque {} ; il y a {}.</translation>
    </message>
    <message>
        <source>{} has several parts: {}. Only {} is used; another can be chosen instead.</source>
        <translation>{} a plusieurs parties : {}. Seule {} est utilisée ; on peut en choisir une autre.</translation>
    </message>
    <message>
        <source>{} has the layers {}; all its channels are used. One layer can be chosen instead.</source>
        <translation>{} a les calques {} ; tous ses canaux sont utilisés. On peut choisir un seul calque.</translation>
    </message>
    <message>
        <source>{} holds stray bytes, which were skipped.</source>
        <translation>{} contient des octets égarés, qui ont été sautés.</translation>
    </message>
    <message>
        <source>{} holds whole numbers of 32 bits from {:.0f} to {:.0f}, which are taken as 0 to 1.</source>
        <translation>{} contient des entiers de 32 bits de {:.0f} à {:.0f}, pris pour 0 à 1.</translation>
    </message>
    <message>
        <source>{} holds {} × {} px from ({}, {}) on, but is meant to show {} × {} px from ({}, {}) on; all that it holds is used.</source>
        <translation>{} contient {} × {} px à partir de ({}, {}), mais doit montrer {} × {} px à partir de ({}, {}) ; tout ce qu&apos;il contient est utilisé.</translation>
    </message>
    <message>
        <source>{} in the edit &quot;{}&quot;: write it as name=value.</source>
        <translation>{} dans la modification « {} » : écrivez nom=valeur.</translation>
    </message>
    <message>
        <source>{} is a model of the kind {}; the input {} takes one of its own kind.</source>
        <translation>{} est un modèle du genre {} ; l&apos;entrée {} n&apos;en prend que du sien.</translation>
    </message>
    <message>
        <source>{} is compressed with loss ({}), which moves the places that a map addresses; save it with zip, piz or none.</source>
        <translation>{} est compressé avec perte ({}), ce qui déplace les points visés par une carte ; enregistrez-le avec zip, piz ou none.</translation>
    </message>
    <message>
        <source>{} is in colours of its own ({}), which were converted.</source>
        <translation>{} est en couleurs propres ({}), qui ont été converties.</translation>
    </message>
    <message>
        <source>{} is no tool that edits an exemplar; those are {}.</source>
        <translation>{} n’est pas un outil qui modifie un échantillon ; ce sont {}.</translation>
    </message>
    <message>
        <source>{} is {} × {} px with {} channels and takes {} of memory to read, more than {}; scale it down or cut it to size first.</source>
        <translation>{} fait {} × {} px avec {} canaux et demande {} de mémoire pour être lu, plus que {} ; réduisez-le ou recadrez-le d&apos;abord.</translation>
    </message>
    <message>
        <source>{} numbers, {}</source>
        <translation>{} nombres, {}</translation>
    </message>
    <message>
        <source>{} points as x,y,x,y,… in px</source>
        <translation>{} points sous la forme x,y,x,y,… en px</translation>
    </message>
    <message>
        <source>{} takes more memory to decode than there is.</source>
        <translation>{} demande pour être décodé plus de mémoire qu&apos;il n&apos;y en a.</translation>
    </message>
    <message>
        <source>{} takes too long to decode; save it again with another program.</source>
        <translation>{} est trop long à décoder ; enregistrez-le de nouveau avec un autre programme.</translation>
    </message>
    <message>
        <source>{} triangles</source>
        <translation>{} triangles</translation>
    </message>
    <message>
        <source>{} was not there before; export again to see what would be replaced.</source>
        <translation>{} est apparu entre-temps ; exportez de nouveau pour voir ce qui serait remplacé.</translation>
    </message>
    <message>
        <source>{}, {}</source>
        <translation>{}, {}</translation>
    </message>
    <message>
        <source>{}: meshes are written as .ply.</source>
        <translation>{} : les maillages s&apos;écrivent en .ply.</translation>
    </message>
    <message>
        <source>{}: {} is written as {}; give the file that extension.</source>
        <translation>{} : {} s&apos;écrit en {} ; donnez cette extension au fichier.</translation>
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
        <translation>{} ne peut pas être lu : ses pixels sont abîmés, ou empaquetés dans l&apos;ancien RLE de Radiance, que Texloom ne lit pas. Enregistrez-le de nouveau avec un autre programme.</translation>
    </message>
    <message>
        <source>{} says it is {} × {} px, but has only {} bytes: it is cut short or damaged.</source>
        <translation>{} prétend faire {} × {} px, mais n&apos;a que {} octets : le fichier est tronqué ou abîmé.</translation>
    </message>
    <message>
        <source>{} would be overwritten by the {} {}: it is {}; name another file.</source>
        <translation>{0} serait écrasé ({1} : {2}), et c&apos;est {3} ; nommez un autre fichier.</translation>
    </message>
    <message>
        <source>{} would need {} of memory, more than {}; use smaller images.</source>
        <translation>{} aurait besoin de {} de mémoire, plus que {} ; utilisez des images plus petites.</translation>
    </message>
    <message>
        <source>Cost of all seams</source>
        <translation>Coût de toutes les coutures</translation>
    </message>
    <message>
        <source>Entire patch</source>
        <translation>Modèle entier</translation>
    </message>
    <message>
        <source>Graph cut</source>
        <translation>Coupe de graphe</translation>
    </message>
    <message>
        <source>How much worse than the best a place may fit and still be likely: larger varies more, smaller fits better.</source>
        <translation>De combien une place peut convenir moins bien que la meilleure et rester probable : plus grand varie davantage, plus petit convient mieux.</translation>
    </message>
    <message>
        <source>Lets seams cost less where the pictures change anyway, so that they follow edges.</source>
        <translation>Fait coûter moins cher les coutures là où les images changent de toute façon, pour qu’elles suivent les contours.</translation>
    </message>
    <message>
        <source>Mended seams</source>
        <translation>Coutures réparées</translation>
    </message>
    <message>
        <source>Mending seams</source>
        <translation>Réparation des coutures</translation>
    </message>
    <message>
        <source>Pastes the whole exemplar again and again, each time along the cheapest seam of any shape, and mends the worst seams at the end. Keeps objects such as stones and leaves whole; copies large areas verbatim.</source>
        <translation>Colle le modèle entier encore et encore, chaque fois le long de la couture la moins coûteuse, de forme quelconque, et répare les pires coutures à la fin. Garde entiers des objets comme pierres et feuilles ; copie de grandes zones telles quelles.</translation>
    </message>
    <message>
        <source>Pasting along cuts</source>
        <translation>Collage le long des coupes</translation>
    </message>
    <message>
        <source>Placement</source>
        <translation>Placement</translation>
    </message>
    <message>
        <source>Random placement looks at nothing, so it cannot follow the initial image; choose entire or sub-patch.</source>
        <translation>Le placement aléatoire ne regarde rien et ne peut donc pas suivre l’image initiale ; choisissez entire ou sub-patch.</translation>
    </message>
    <message>
        <source>Seam cost per pixel</source>
        <translation>Coût de couture par pixel</translation>
    </message>
    <message>
        <source>Seams along edges</source>
        <translation>Coutures le long des contours</translation>
    </message>
    <message>
        <source>Side of the square that is compared for sub-patches and for mending: larger keeps larger structures whole.</source>
        <translation>Côté du carré comparé pour les sous-patchs et les réparations : plus grand garde entières de plus grandes structures.</translation>
    </message>
    <message>
        <source>So many times the worst seam is pasted over, where that makes it better: more takes longer and hides more.</source>
        <translation>Autant de fois la pire couture est recouverte, là où c’est mieux : davantage prend plus de temps et cache plus.</translation>
    </message>
    <message>
        <source>Sub-patch</source>
        <translation>Sous-patch</translation>
    </message>
    <message>
        <source>The mask hides all of the exemplar; leave at least 1 px to copy.</source>
        <translation>Le masque cache tout le modèle ; laissez au moins 1 px à copier.</translation>
    </message>
    <message>
        <source>Where the exemplar is pasted next: anywhere, where all of it fits what is there, or where a square of it does, which suits what has no clear structure.</source>
        <translation>Où le modèle est collé ensuite : n’importe où, là où il convient tout entier à ce qui est là, ou là où un carré de lui convient, ce qui est bon pour ce qui n’a pas de structure nette.</translation>
    </message>
    <message>
        <source>{} is {} × {} px, smaller than the compared square of {} px; choose one of at most {} px.</source>
        <translation>{} fait {} × {} px, moins que le carré comparé de {} px ; choisissez-en un d’au plus {} px.</translation>
    </message>
    <message>
        <source>A picture of the result&apos;s size whose shapes the exemplar takes on.</source>
        <translation>Une image de la taille du résultat dont l’échantillon prend les formes.</translation>
    </message>
    <message>
        <source>A tree finds a neighbourhood that is nearly the nearest, in time that hardly grows with the exemplar; exact compares all of them.</source>
        <translation>Un arbre trouve un voisinage presque le plus proche, en un temps qui ne croît guère avec l’échantillon ; exacte les compare tous.</translation>
    </message>
    <message>
        <source>Ashikhmin</source>
        <translation>Ashikhmin</translation>
    </message>
    <message>
        <source>At most so many waves, the strongest: more follow finer regularity and take longer.</source>
        <translation>Au plus autant d’ondes, les plus fortes : davantage suit une régularité plus fine et prend plus de temps.</translation>
    </message>
    <message>
        <source>At most so many, each half the size of the one before: more keep larger structures.</source>
        <translation>Au plus autant, chacune deux fois plus petite que la précédente : davantage garde de plus grandes structures.</translation>
    </message>
    <message>
        <source>Coherence</source>
        <translation>Cohérence</translation>
    </message>
    <message>
        <source>Components</source>
        <translation>Composantes</translation>
    </message>
    <message>
        <source>Copying pixels one by one</source>
        <translation>Copie des pixels un à un</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Distance</translation>
    </message>
    <message>
        <source>Drawing the regular part</source>
        <translation>Tracé de la partie régulière</translation>
    </message>
    <message>
        <source>Drift over the output, in cycles</source>
        <translation>Dérive sur la sortie, en périodes</translation>
    </message>
    <message>
        <source>Efros–Leung</source>
        <translation>Efros–Leung</translation>
    </message>
    <message>
        <source>Finding waves</source>
        <translation>Recherche des ondes</translation>
    </message>
    <message>
        <source>Finding what looks alike</source>
        <translation>Recherche de ce qui se ressemble</translation>
    </message>
    <message>
        <source>Finds out once which places of the exemplar look alike, and then walks through it, jumping between them. The fastest of the methods that work pixel by pixel; joins are rougher than Ashikhmin&apos;s.</source>
        <translation>Détermine une fois quels endroits de l’échantillon se ressemblent, puis le parcourt en sautant de l’un à l’autre. La plus rapide des méthodes pixel par pixel ; les raccords sont plus rudes que chez Ashikhmin.</translation>
    </message>
    <message>
        <source>Finds the waves that a near-regular exemplar is made of, to a fraction of a cycle, continues them over the output, and quilts patches that follow them. Suits weaves, bricks and tiles that are seen straight on.</source>
        <translation>Trouve à une fraction de période près les ondes qui composent un échantillon presque régulier, les prolonge sur la sortie et coud des patchs qui les suivent. Convient aux tissages, briques et carreaux vus de face.</translation>
    </message>
    <message>
        <source>Fourier mask</source>
        <translation>Masque de Fourier</translation>
    </message>
    <message>
        <source>Growing pixels</source>
        <translation>Croissance des pixels</translation>
    </message>
    <message>
        <source>Grows outwards from what is known, layer by layer, or row by row from the top left.</source>
        <translation>Croît à partir de ce qui est connu, couche par couche, ou ligne par ligne depuis le haut à gauche.</translation>
    </message>
    <message>
        <source>How closely the target is followed, if there is one: larger follows it more, smaller keeps more of the exemplar&apos;s structure.</source>
        <translation>Avec quelle précision la cible est suivie, s’il y en a une : plus grand, il la suit davantage ; plus petit, il garde plus de la structure de l’échantillon.</translation>
    </message>
    <message>
        <source>How far from its own place in an exemplar of the output&apos;s size a pixel&apos;s source may lie, as in a photo that is mended: smaller takes what is near, and is faster; 0 looks everywhere.</source>
        <translation>À quelle distance de sa propre place, dans un échantillon de la taille de la sortie, la source d&apos;un pixel peut se trouver, comme dans une photo que l&apos;on répare : plus petit prend ce qui est proche et va plus vite ; 0 cherche partout.</translation>
    </message>
    <message>
        <source>How far from the middle pixels of the window count, as a share of the window: larger looks further, smaller trusts the nearest.</source>
        <translation>Jusqu’à quelle distance du milieu les pixels de la fenêtre comptent, en part de la fenêtre : plus grand, il regarde plus loin ; plus petit, il se fie aux plus proches.</translation>
    </message>
    <message>
        <source>How far these lie from the pixel and from each other at least: larger leads to more different parts of the exemplar.</source>
        <translation>À quelle distance du pixel et les uns des autres ils se trouvent au moins : plus grande, elle mène vers des parties plus différentes de l’échantillon.</translation>
    </message>
    <message>
        <source>How likely a random pixel of the exemplar may be chosen too: larger varies more and copies smaller pieces.</source>
        <translation>Avec quelle probabilité un pixel quelconque de l’échantillon peut aussi être choisi : plus grand, il varie davantage et copie de plus petits morceaux.</translation>
    </message>
    <message>
        <source>How likely a walk jumps where another place looks the same: larger copies smaller pieces.</source>
        <translation>Avec quelle probabilité on saute là où un autre endroit a le même aspect : plus grande, elle copie de plus petits morceaux.</translation>
    </message>
    <message>
        <source>How much pictures A and B count beside the exemplar: larger follows them more closely.</source>
        <translation>Combien les images A et B comptent à côté de l’échantillon : plus grand, elles sont suivies de plus près.</translation>
    </message>
    <message>
        <source>How much the regular part counts beside the fit of overlaps: larger keeps the order, 0 quilts without it.</source>
        <translation>Combien compte la partie régulière à côté de l’accord des recouvrements : plus garde l’ordre, 0 coud sans elle.</translation>
    </message>
    <message>
        <source>How much worse a pixel may fit that continues the copy beside it: larger copies larger pieces, 0 takes whatever fits best.</source>
        <translation>De combien un pixel qui continue la copie voisine peut convenir moins bien : plus grand, il copie de plus grands morceaux ; 0 prend ce qui convient le mieux.</translation>
    </message>
    <message>
        <source>How much worse than the best a window may fit and still be drawn: larger varies more, smaller copies longer stretches.</source>
        <translation>De combien une fenêtre peut convenir moins bien que la meilleure et être tirée quand même : plus grand, cela varie davantage ; plus petit, cela copie de plus longs passages.</translation>
    </message>
    <message>
        <source>How often each scale is made: passes after the first see all that surrounds a pixel, which repairs seams.</source>
        <translation>Combien de fois chaque échelle est faite : les passages après le premier voient tout ce qui entoure un pixel, ce qui répare les raccords.</translation>
    </message>
    <message>
        <source>How often the output is gone through: passes after the first see all that surrounds a pixel, which repairs seams.</source>
        <translation>Combien de fois le résultat est parcouru : les passages après le premier voient tout ce qui entoure un pixel, ce qui répare les raccords.</translation>
    </message>
    <message>
        <source>Image analogies</source>
        <translation>Analogies d’images</translation>
    </message>
    <message>
        <source>Jump</source>
        <translation>Saut</translation>
    </message>
    <message>
        <source>Jump map</source>
        <translation>Carte de sauts</translation>
    </message>
    <message>
        <source>Jump probability</source>
        <translation>Probabilité de saut</translation>
    </message>
    <message>
        <source>Jumps</source>
        <translation>Sauts</translation>
    </message>
    <message>
        <source>Known</source>
        <translation>Connu</translation>
    </message>
    <message>
        <source>Largest move to close, in cycles</source>
        <translation>Plus grand déplacement pour fermer, en périodes</translation>
    </message>
    <message>
        <source>Leaf</source>
        <translation>Feuille</translation>
    </message>
    <message>
        <source>Makes one pixel after another in rows, from coarse to fine, and takes each from where the exemplar looks most like what is there above and to the left. Always tiles from left to right; small details may become blurred.</source>
        <translation>Crée un pixel après l’autre, ligne par ligne, du grossier au fin, et prend chacun là où l’échantillon ressemble le plus à ce qui se trouve au-dessus et à gauche. Se raccorde toujours de gauche à droite ; les petits détails peuvent devenir flous.</translation>
    </message>
    <message>
        <source>Makes one pixel after another in rows; each continues one of the copies that its neighbours belong to, so that pieces of the exemplar grow until they meet. Very fast, and at its best on natural textures such as grass, leaves and pebbles.</source>
        <translation>Crée un pixel après l’autre, ligne par ligne ; chacun continue l’une des copies auxquelles ses voisins appartiennent, si bien que des morceaux de l’échantillon croissent jusqu’à se rencontrer. Très rapide, et à son mieux sur les textures naturelles comme l’herbe, les feuilles et les galets.</translation>
    </message>
    <message>
        <source>Makes what stands to picture B as the exemplar stands to picture A: paint the exemplar&apos;s materials as flat colours in A, and where they are to be in B. Without the pictures it makes more of the exemplar.</source>
        <translation>Fait ce qui est à l’image B ce que l’échantillon est à l’image A : peignez dans A des couleurs unies pour les matières de l’échantillon, et dans B là où elles doivent être, et le résultat y a ces matières. Sans ces images, il fait davantage de l’échantillon.</translation>
    </message>
    <message>
        <source>Mean distance of the neighbourhoods</source>
        <translation>Distance moyenne des voisinages</translation>
    </message>
    <message>
        <source>Neighbourhoods in a leaf of the tree: larger finds nearer ones, but takes longer.</source>
        <translation>Voisinages dans une feuille de l’arbre : plus grand, elle en trouve de plus proches, mais prend plus de temps.</translation>
    </message>
    <message>
        <source>Onion</source>
        <translation>Oignon</translation>
    </message>
    <message>
        <source>Only {:.1f} % of {} is regular, less than {:.0f} %, so hardly anything guides the patches; lower the threshold, or use image quilting.</source>
        <translation>Seuls {} % de {} sont réguliers, moins de {} % : presque rien ne guide les patchs ; baissez le seuil, ou prenez le quilting d’images.</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Ordre</translation>
    </message>
    <message>
        <source>Parent square</source>
        <translation>Carré parent</translation>
    </message>
    <message>
        <source>Peaks of the spectrum this high, over the highest, count as waves: smaller finds more of them, and takes chance for rule.</source>
        <translation>Les pics du spectre de cette hauteur, par rapport au plus haut, comptent comme ondes : moins en trouve davantage et prend le hasard pour la règle.</translation>
    </message>
    <message>
        <source>Picture A</source>
        <translation>Image A</translation>
    </message>
    <message>
        <source>Picture B</source>
        <translation>Image B</translation>
    </message>
    <message>
        <source>Picture B has the colour {}, which picture A has nowhere; paint it in A, too, or use A&apos;s colours: {}.</source>
        <translation>L’image B a la couleur {}, que l’image A n’a nulle part ; peignez-la aussi dans A, ou prenez les couleurs de A : {}.</translation>
    </message>
    <message>
        <source>Places that are kept for each pixel of the exemplar because they look like it: more vary more.</source>
        <translation>Endroits gardés pour chaque pixel de l’échantillon parce qu’ils lui ressemblent : davantage font varier plus.</translation>
    </message>
    <message>
        <source>Principal components</source>
        <translation>Composantes principales</translation>
    </message>
    <message>
        <source>Principal components by which likely windows are found: more find nearer ones, but take longer.</source>
        <translation>Composantes principales par lesquelles les fenêtres probables sont trouvées : davantage en trouvent de plus proches, mais prennent plus de temps.</translation>
    </message>
    <message>
        <source>Regular part</source>
        <translation>Partie régulière</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>Lignes</translation>
    </message>
    <message>
        <source>Search radius</source>
        <translation>Rayon de recherche</translation>
    </message>
    <message>
        <source>Seed size</source>
        <translation>Taille du germe</translation>
    </message>
    <message>
        <source>Share of the variance in the regular part</source>
        <translation>Part de la variance dans la partie régulière</translation>
    </message>
    <message>
        <source>Side of the square of the exemplar that growth begins with, at most the window: larger begins with more structure.</source>
        <translation>Côté du carré de l’échantillon par lequel la croissance commence, au plus la fenêtre : plus grand, elle commence avec plus de structure.</translation>
    </message>
    <message>
        <source>Side of the square that is compared (an even one counts as the next odd): larger keeps larger structures, but takes longer.</source>
        <translation>Côté du carré comparé (un côté pair compte comme l’impair suivant) : plus grand, il garde de plus grandes structures, mais prend plus de temps.</translation>
    </message>
    <message>
        <source>Side of the square that is compared (an even one counts as the next odd): too small grows garbage, too large copies verbatim.</source>
        <translation>Côté du carré comparé (un côté pair compte comme l’impair suivant) : trop petit, il engendre du désordre ; trop grand, il copie mot à mot.</translation>
    </message>
    <message>
        <source>Side of the square that is compared on the next coarser scale (an even one counts as the next odd): larger follows the coarser scale more closely; 0 forgets it.</source>
        <translation>Côté du carré comparé à l’échelle plus grossière (un côté pair compte comme l’impair suivant) : plus grand, il suit cette échelle de plus près ; 0 l’oublie.</translation>
    </message>
    <message>
        <source>Side of the square whose known half is compared (an even one counts as the next odd): larger keeps larger structures, but takes longer and copies more.</source>
        <translation>Côté du carré dont la moitié connue est comparée (un côté pair compte comme l’impair suivant) : plus grand, il garde de plus grandes structures, mais prend plus de temps et copie davantage.</translation>
    </message>
    <message>
        <source>Side of the squares by which places look alike (an even one counts as the next odd): larger jumps only where larger structures agree.</source>
        <translation>Côté des carrés selon lesquels les endroits se ressemblent (un côté pair compte comme l’impair suivant) : plus grand, on ne saute que là où de plus grandes structures s’accordent.</translation>
    </message>
    <message>
        <source>Side of the squares that are copied: larger keeps larger structures whole, smaller follows the waves more closely.</source>
        <translation>Côté des carrés copiés : plus grand garde entières de plus grandes structures, plus petit suit mieux les ondes.</translation>
    </message>
    <message>
        <source>Sigma</source>
        <translation>Sigma</translation>
    </message>
    <message>
        <source>Target weight</source>
        <translation>Poids de la cible</translation>
    </message>
    <message>
        <source>There is a mask of what is known, but no image to start from; give that too.</source>
        <translation>Il y a un masque de ce qui est connu, mais pas d’image de départ ; donnez-la aussi.</translation>
    </message>
    <message>
        <source>There is a picture B, but {} has no picture A; give both, or none.</source>
        <translation>Il y a une image B, mais {} n’a pas d’image A ; donnez les deux, ou aucune.</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>Seuil</translation>
    </message>
    <message>
        <source>Tree</source>
        <translation>Arbre</translation>
    </message>
    <message>
        <source>Walking through the exemplar</source>
        <translation>Parcours de l’échantillon</translation>
    </message>
    <message>
        <source>Waves</source>
        <translation>Ondes</translation>
    </message>
    <message>
        <source>Weight of A and B</source>
        <translation>Poids de A et B</translation>
    </message>
    <message>
        <source>Weight of the waves</source>
        <translation>Poids des ondes</translation>
    </message>
    <message>
        <source>Wei–Levoy</source>
        <translation>Wei–Levoy</translation>
    </message>
    <message>
        <source>Nothing says what to keep of the image to start from; give a mask of what is known.</source>
        <translation>Ce qui doit rester de l’image de départ n’est pas dit ; donnez un masque de ce qui est connu.</translation>
    </message>
    <message>
        <source>What of the image to start from is kept; the rest, where it is black, is made again.</source>
        <translation>Ce qui reste de l’image de départ ; le reste, là où il est noir, est refait.</translation>
    </message>
    <message>
        <source>What the exemplar is made of, pixel for pixel: flat colours for its materials, or the picture before a filter made the exemplar of it.</source>
        <translation>De quoi l’échantillon est fait, pixel par pixel : des couleurs unies pour ses matières, ou l’image avant qu’un filtre en ait fait l’échantillon.</translation>
    </message>
    <message>
        <source>What the result is to be made of, in the colours of picture A.</source>
        <translation>De quoi le résultat doit être fait, dans les couleurs de l’image A.</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fenêtre</translation>
    </message>
    <message>
        <source>{} has a picture A, but there is no picture B; give both, or none.</source>
        <translation>{} a une image A, mais il n’y a pas d’image B ; donnez les deux, ou aucune.</translation>
    </message>
    <message>
        <source>{} is {} × {} px, smaller than the neighbourhood of {} px; choose a neighbourhood of at most {} px, or a larger exemplar.</source>
        <translation>{} fait {} × {} px, moins que le voisinage de {} px ; choisissez un voisinage d’au plus {} px ou un échantillon plus grand.</translation>
    </message>
    <message>
        <source>{} is not the file any more that the result was made from.</source>
        <translation>{} n’est plus le fichier dont le résultat a été fait.</translation>
    </message>
    <message>
        <source>+ cuts</source>
        <translation>+ coupes</translation>
    </message>
    <message>
        <source>+ frequencies of atoms</source>
        <translation>+ fréquences des atomes</translation>
    </message>
    <message>
        <source>+ low frequencies: all of it</source>
        <translation>+ basses fréquences : le tout</translation>
    </message>
    <message>
        <source>+ scales</source>
        <translation>+ échelles</translation>
    </message>
    <message>
        <source>A hole has no overlaps of even width to blend; choose the stitch cut, smooth-cut, none or poisson.</source>
        <translation>Un trou n’a pas de recouvrements de largeur égale à mélanger ; choisissez la couture cut, smooth-cut, none ou poisson.</translation>
    </message>
    <message>
        <source>A learnt dictionary of this exemplar, so that none is learned again.</source>
        <translation>Un dictionnaire appris de cet échantillon, afin de n’en pas apprendre un nouveau.</translation>
    </message>
    <message>
        <source>A patch of {} px has {} values, so that it cannot have {} atoms; choose at most {}.</source>
        <translation>Un patch de {} px a {} valeurs et ne peut donc pas avoir {} atomes ; choisissez-en au plus {}.</translation>
    </message>
    <message>
        <source>Across</source>
        <translation>Horizontal</translation>
    </message>
    <message>
        <source>Affine in two pieces</source>
        <translation>Affine en deux morceaux</translation>
    </message>
    <message>
        <source>All constraints of Tartavel, Gousseau and Peyré with their numbers, at the exemplar&apos;s size with its own low frequencies.</source>
        <translation>Toutes les contraintes de Tartavel, Gousseau et Peyré avec leurs valeurs, à la taille de l’échantillon et avec ses propres basses fréquences.</translation>
    </message>
    <message>
        <source>All tiles alike</source>
        <translation>Tous les pavés pareils</translation>
    </message>
    <message>
        <source>All tiles alike are copies of one; varied ones differ as the exemplar&apos;s tiles differ from their mean, and are a little softer.</source>
        <translation>Des pavés pareils sont des copies d’un seul ; variés, ils diffèrent comme ceux de l’échantillon diffèrent de leur moyenne, et sont un peu plus doux.</translation>
    </message>
    <message>
        <source>Along which axes colours are distributed as in the exemplar: principal axes keep how channels go together.</source>
        <translation>Les axes le long desquels les couleurs sont réparties comme dans l’échantillon : les axes principaux gardent le lien entre les canaux.</translation>
    </message>
    <message>
        <source>Amplitude</source>
        <translation>Amplitude</translation>
    </message>
    <message>
        <source>An amplitude of {} would fold the picture; it was lowered to {:.3f}, the most that surely does not.</source>
        <translation>Une amplitude de {} replierait l’image ; elle a été abaissée à {:.3f}, le plus qui ne le fait sûrement pas.</translation>
    </message>
    <message>
        <source>Anamorphosis</source>
        <translation>Anamorphose</translation>
    </message>
    <message>
        <source>Ashikhmin: pieces that grow</source>
        <translation>Ashikhmin : des morceaux qui grandissent</translation>
    </message>
    <message>
        <source>At scale 1/{} there are {} patches to learn from, so that the dictionary has {} atoms instead of {}.</source>
        <translation>À l’échelle 1/{} il y a {} patches pour apprendre, si bien que le dictionnaire a {} atomes au lieu de {}.</translation>
    </message>
    <message>
        <source>Atoms</source>
        <translation>Atomes</translation>
    </message>
    <message>
        <source>Atoms describe how patches differ from the exemplar&apos;s mean colour, rather than from black, as published: of use for maps with values far from 0, and blurrier for pictures.</source>
        <translation>Les atomes décrivent l’écart des patches à la couleur moyenne de l’échantillon plutôt qu’au noir, comme publié : utile pour des cartes aux valeurs loin de 0, plus flou pour des images.</translation>
    </message>
    <message>
        <source>Atoms in use</source>
        <translation>Atomes utilisés</translation>
    </message>
    <message>
        <source>Atoms of a patch</source>
        <translation>Atomes d’un patch</translation>
    </message>
    <message>
        <source>Atoms of the dictionary at each scale: more tell more features apart, and take longer to learn.</source>
        <translation>Atomes du dictionnaire à chaque échelle : davantage distinguent plus de motifs et demandent plus de temps d’apprentissage.</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatique</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Axe</translation>
    </message>
    <message>
        <source>Basic (Peyré 2009)</source>
        <translation>Base (Peyré 2009)</translation>
    </message>
    <message>
        <source>Between pixels: cubic is sharpest, linear never overshoots, the nearest pixel is copied as it is.</source>
        <translation>Entre les pixels : cubique est le plus net, linéaire ne dépasse jamais, le pixel le plus proche est copié tel quel.</translation>
    </message>
    <message>
        <source>Beyond the border</source>
        <translation>Au-delà du bord</translation>
    </message>
    <message>
        <source>Blocks</source>
        <translation>Blocs</translation>
    </message>
    <message>
        <source>Blocks are drawn at random along the lattice and make new tiles of parts of several; whole tiles are stitched one after another, each to fit those before.</source>
        <translation>Les blocs sont tirés au hasard le long du réseau et forment de nouveaux pavés à partir de plusieurs ; les pavés entiers sont cousus l’un après l’autre, chacun selon les précédents.</translation>
    </message>
    <message>
        <source>Both ways</source>
        <translation>Dans les deux sens</translation>
    </message>
    <message>
        <source>Chaos</source>
        <translation>Chaos</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>Colonnes</translation>
    </message>
    <message>
        <source>Context</source>
        <translation>Contexte</translation>
    </message>
    <message>
        <source>Cubic</source>
        <translation>Cubique</translation>
    </message>
    <message>
        <source>Curve of the map</source>
        <translation>Courbe de la carte</translation>
    </message>
    <message>
        <source>Cuts</source>
        <translation>Coupes</translation>
    </message>
    <message>
        <source>Cuts the exemplars into pieces, shuffles them so that each is used once, and levels the joints. Keeps large natural textures such as stone and metal from repeating; long structures across pieces are lost.</source>
        <translation>Découpe les modèles en morceaux, les mélange pour que chacun serve une fois et nivelle les joints. Évite que de grandes textures naturelles comme la pierre et le métal se répètent ; les longues structures à travers les morceaux sont perdues.</translation>
    </message>
    <message>
        <source>Deforming</source>
        <translation>Déformation</translation>
    </message>
    <message>
        <source>Deforms the exemplar, or what another method made of it, lightly and without folds: stretched along one axis, or as if seen through hot air. Hides repetitions a little; what is salient is still known again.</source>
        <translation>Déforme le modèle, ou ce qu’une autre méthode en a fait, légèrement et sans plis : étiré le long d’un axe, ou comme vu à travers de l’air chaud. Cache un peu les répétitions ; ce qui est saillant se reconnaît encore.</translation>
    </message>
    <message>
        <source>Dictionary</source>
        <translation>Dictionnaire</translation>
    </message>
    <message>
        <source>Dictionary at scale 1/{}</source>
        <translation>Dictionnaire à l’échelle 1/{}</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Vertical</translation>
    </message>
    <message>
        <source>Drawing the deformation</source>
        <translation>Tirage de la déformation</translation>
    </message>
    <message>
        <source>Drawn</source>
        <translation>Tirage</translation>
    </message>
    <message>
        <source>Draws the colours towards the exemplar&apos;s distribution.</source>
        <translation>Tire les couleurs vers la répartition de l’échantillon.</translation>
    </message>
    <message>
        <source>Draws the image towards the exemplar&apos;s Fourier spectrum: brings fine grain back, which few atoms cannot code.</source>
        <translation>Tire l’image vers le spectre de Fourier de l’échantillon : rend le grain fin, que peu d’atomes ne peuvent coder.</translation>
    </message>
    <message>
        <source>Draws what is larger than a patch towards a target, so that no large blotches arise.</source>
        <translation>Tire ce qui dépasse un patch vers une cible, pour qu’aucune grande tache n’apparaisse.</translation>
    </message>
    <message>
        <source>Efros–Leung: the window</source>
        <translation>Efros–Leung : la fenêtre</translation>
    </message>
    <message>
        <source>Energy</source>
        <translation>Énergie</translation>
    </message>
    <message>
        <source>Energy of a pixel</source>
        <translation>Énergie d’un pixel</translation>
    </message>
    <message>
        <source>Every tile by itself, in the order of the table.</source>
        <translation>Chaque pavé seul, dans l’ordre de la table.</translation>
    </message>
    <message>
        <source>Feather</source>
        <translation>Fondu</translation>
    </message>
    <message>
        <source>Figure 2 of Tartavel, Gousseau and Peyré: Heeger–Bergen, Portilla–Simoncelli, sparse synthesis, and Peyré&apos;s method of 2009.</source>
        <translation>Figure 2 de Tartavel, Gousseau et Peyré : Heeger–Bergen, Portilla–Simoncelli, synthèse parcimonieuse et la méthode de Peyré de 2009.</translation>
    </message>
    <message>
        <source>Figure 4 of Tartavel, Gousseau and Peyré: from Peyré&apos;s method of 2009, each run adds one constraint to those before it.</source>
        <translation>Figure 4 de Tartavel, Gousseau et Peyré : à partir de la méthode de Peyré de 2009, chaque calcul ajoute une contrainte aux précédentes.</translation>
    </message>
    <message>
        <source>Flips pieces and turns them by 180° at random: varies more, but light then comes from several sides, also in companion normal maps.</source>
        <translation>Retourne des morceaux et les tourne de 180° au hasard : plus de variété, mais la lumière vient alors de plusieurs côtés, aussi dans les cartes de normales associées.</translation>
    </message>
    <message>
        <source>For outputs larger than the exemplar: low frequencies of random phases, lightly held, and one scale more.</source>
        <translation>Pour des sorties plus grandes que l’échantillon : basses fréquences à phases aléatoires, peu contraintes, et une échelle de plus.</translation>
    </message>
    <message>
        <source>Frequencies of atoms</source>
        <translation>Fréquences des atomes</translation>
    </message>
    <message>
        <source>From one patch that is learnt from to the next: wider steps in a small exemplar leave so few patches that the atoms merely repeat them. At most 20 patches for each atom are used.</source>
        <translation>D’un patch d’apprentissage au suivant : de grands pas dans un petit échantillon laissent si peu de patches que les atomes ne font que les répéter. Au plus 20 patches par atome sont utilisés.</translation>
    </message>
    <message>
        <source>From one patch to the next, at most the patch size: closer is surer and takes longer; half the patch is published.</source>
        <translation>D’un patch au suivant, au plus la taille du patch : plus serré est plus sûr et plus long ; la moitié du patch est publiée.</translation>
    </message>
    <message>
        <source>From the exemplar’s tiles</source>
        <translation>Parmi les pavés de l’échantillon</translation>
    </message>
    <message>
        <source>From the mean</source>
        <translation>À partir de la moyenne</translation>
    </message>
    <message>
        <source>Gradient steps</source>
        <translation>Pas de gradient</translation>
    </message>
    <message>
        <source>Histogram</source>
        <translation>Histogramme</translation>
    </message>
    <message>
        <source>How a patch is joined to its neighbours: a cut, or none, keeps every pixel as it is in the exemplar; the others blend where patches overlap.</source>
        <translation>Comment une pièce est jointe à ses voisines : une coupe, ou aucune, laisse chaque pixel tel qu’il est dans l’échantillon ; les autres mélangent là où les pièces se recouvrent.</translation>
    </message>
    <message>
        <source>How far from a joint levels are drawn together, in sides of a piece: larger hides joints over more of a piece, and lets shades drift; 0 levels without limit.</source>
        <translation>Jusqu’où d’un joint les niveaux sont rapprochés, en côtés de morceau : plus grand cache les joints sur une plus grande part du morceau et laisse dériver les nuances ; 0 nivelle sans limite.</translation>
    </message>
    <message>
        <source>How far into each other neighbouring tiles fade, up to half a tile: more hides their edges, less is sharper.</source>
        <translation>Jusqu’où des pavés voisins se fondent l’un dans l’autre, au plus un demi-pavé : davantage cache leurs bords, moins est plus net.</translation>
    </message>
    <message>
        <source>How many atoms make up a patch: more follow the exemplar more closely, fewer keep edges clean.</source>
        <translation>Nombre d’atomes qui composent un patch : davantage suivent l’échantillon de plus près, moins gardent des bords nets.</translation>
    </message>
    <message>
        <source>How much a patch that is used too often is avoided: larger shows all of the exemplar, 0 takes whatever fits best, as a hole does that is filled.</source>
        <translation>À quel point une pièce trop souvent utilisée est évitée : plus grand montre tout l’échantillon, 0 prend ce qui convient le mieux, comme un trou que l’on remplit.</translation>
    </message>
    <message>
        <source>How much of each component a tile gets: normally distributed, which makes what the exemplar does not show, or as much as some tile of the exemplar has.</source>
        <translation>Combien de chaque composante un pavé reçoit : selon la loi normale, ce qui donne aussi ce que l’échantillon ne montre pas, ou autant qu’un pavé de l’échantillon.</translation>
    </message>
    <message>
        <source>How much the distribution of colours counts against the patches.</source>
        <translation>Le poids de la répartition des couleurs face aux patches.</translation>
    </message>
    <message>
        <source>How much the low frequencies count against the patches.</source>
        <translation>Le poids des basses fréquences face aux patches.</translation>
    </message>
    <message>
        <source>How much the spectrum counts against the patches.</source>
        <translation>Le poids du spectre face aux patches.</translation>
    </message>
    <message>
        <source>How overlapping patches are put together: joined along cuts, which is sharp, or averaged, which blurs.</source>
        <translation>Comment les patches qui se recouvrent sont assemblés : le long de coupes, ce qui est net, ou moyennés, ce qui rend flou.</translation>
    </message>
    <message>
        <source>How strongly: 0 changes nothing; near 1 the most squeezed places shrink to almost nothing. Turbulence is lowered until nothing folds.</source>
        <translation>Avec quelle force : 0 ne change rien ; près de 1, les endroits les plus comprimés se réduisent à presque rien. La turbulence est abaissée jusqu’à ce que rien ne se replie.</translation>
    </message>
    <message>
        <source>How the exemplar goes on where the output is larger or wraps: mirrored it joins with itself; repeat one that tiles.</source>
        <translation>Comment le modèle continue là où la sortie est plus grande ou se raccorde : en miroir il se joint à lui-même ; répétez celui qui se raccorde déjà.</translation>
    </message>
    <message>
        <source>Image analogies with painted pictures: A says where the exemplar&apos;s stones and gaps are, B where they are to be; the two count more from run to run.</source>
        <translation>Analogies d’images avec des images peintes : A dit où sont les pierres et les joints de l’échantillon, B où ils doivent être ; les deux comptent davantage d’un calcul à l’autre.</translation>
    </message>
    <message>
        <source>In how many principal components tiles vary, at most: more show finer differences, 0 repeats the mean tile.</source>
        <translation>Nombre maximal de composantes principales selon lesquelles les pavés varient : davantage montre des différences plus fines, 0 répète le pavé moyen.</translation>
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
        <translation>K-SVD améliore chaque atome pour tous les patches qui l’utilisent et apprend mieux ; l’apprentissage en ligne regarde peu de patches à la fois.</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Genre</translation>
    </message>
    <message>
        <source>Laying pieces</source>
        <translation>Pose des morceaux</translation>
    </message>
    <message>
        <source>Learning</source>
        <translation>Apprentissage</translation>
    </message>
    <message>
        <source>Learning at scale 1/{}</source>
        <translation>Apprentissage à l’échelle 1/{}</translation>
    </message>
    <message>
        <source>Learning rounds</source>
        <translation>Tours d’apprentissage</translation>
    </message>
    <message>
        <source>Learning step</source>
        <translation>Pas d’apprentissage</translation>
    </message>
    <message>
        <source>Learns atoms of which a few make up any patch of the exemplar, and shows them, those used most first. Sparse synthesis takes the dictionary up, so that it is learnt only once.</source>
        <translation>Apprend des atomes dont quelques-uns composent tout patch de l’échantillon, et les montre, les plus utilisés d’abord. La synthèse parcimonieuse reprend le dictionnaire, qui n’est ainsi appris qu’une fois.</translation>
    </message>
    <message>
        <source>Least determinant of the Jacobian</source>
        <translation>Plus petit déterminant de la jacobienne</translation>
    </message>
    <message>
        <source>Levelling joints</source>
        <translation>Nivellement des joints</translation>
    </message>
    <message>
        <source>Levelling reach</source>
        <translation>Portée du nivellement</translation>
    </message>
    <message>
        <source>Low frequencies</source>
        <translation>Basses fréquences</translation>
    </message>
    <message>
        <source>Low frequencies of</source>
        <translation>Basses fréquences de</translation>
    </message>
    <message>
        <source>Makes an image whose patches are each a sum of few learnt atoms, used as often as in the exemplar. New pixels rather than copies; sharp on small structures such as scales, weaves and cracks, and lost on large objects and on grain.</source>
        <translation>Produit une image dont chaque patch est la somme de quelques atomes appris, utilisés aussi souvent que dans l’échantillon. De nouveaux pixels plutôt que des copies ; net sur les petites structures comme les écailles, les tissages et les fissures, perdu sur les grands objets et le grain.</translation>
    </message>
    <message>
        <source>Map of the sheet</source>
        <translation>Carte de la planche</translation>
    </message>
    <message>
        <source>Mean tile and components</source>
        <translation>Pavé moyen et composantes</translation>
    </message>
    <message>
        <source>Most rounds at each scale: more bring patches and image closer together.</source>
        <translation>Nombre maximal de tours à chaque échelle : davantage rapprochent patches et image.</translation>
    </message>
    <message>
        <source>Moving blocks</source>
        <translation>Déplacement des blocs</translation>
    </message>
    <message>
        <source>Nearest pixel</source>
        <translation>Pixel le plus proche</translation>
    </message>
    <message>
        <source>No atom is used more often than in the exemplar: brings all features back, and keeps smooth patches from spreading.</source>
        <translation>Aucun atome n’est utilisé plus souvent que dans l’échantillon : rend tous les motifs et empêche les patches lisses de s’étendre.</translation>
    </message>
    <message>
        <source>Normally</source>
        <translation>Selon la loi normale</translation>
    </message>
    <message>
        <source>Online</source>
        <translation>En ligne</translation>
    </message>
    <message>
        <source>Parabola</source>
        <translation>Parabole</translation>
    </message>
    <message>
        <source>Patches learnt from</source>
        <translation>Patches d’apprentissage</translation>
    </message>
    <message>
        <source>Peyré 2009</source>
        <translation>Peyré 2009</translation>
    </message>
    <message>
        <source>Piece size</source>
        <translation>Taille des morceaux</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>Morceaux</translation>
    </message>
    <message>
        <source>Pieces of the exemplar grow until nothing fits; jumps from 0 to 0.2 make them smaller. See the tab Copied pieces.</source>
        <translation>Des morceaux de l’échantillon grandissent jusqu’à ce que rien ne convienne plus ; des sauts de 0 à 0,2 les rendent plus petits. Voir l’onglet Morceaux copiés.</translation>
    </message>
    <message>
        <source>Poisson levels the joints and keeps the detail; a cut copies every pixel as it is; feathering blurs where pieces overlap; none shows the pieces.</source>
        <translation>Poisson nivelle les joints et garde le détail ; une coupe copie chaque pixel tel quel ; le fondu estompe là où les morceaux se recouvrent ; sans, on voit les morceaux.</translation>
    </message>
    <message>
        <source>Random mosaic</source>
        <translation>Mosaïque aléatoire</translation>
    </message>
    <message>
        <source>Reconstruction</source>
        <translation>Reconstruction</translation>
    </message>
    <message>
        <source>Repeat</source>
        <translation>Répéter</translation>
    </message>
    <message>
        <source>Root mean square error</source>
        <translation>Racine de l’erreur quadratique moyenne</translation>
    </message>
    <message>
        <source>Rounds over all patches that are learnt from: more learn better, and take longer.</source>
        <translation>Tours sur tous les patches d’apprentissage : davantage apprennent mieux et durent plus longtemps.</translation>
    </message>
    <message>
        <source>Row by row on a single scale, with neighbourhoods of 5, 9, 15 and 21 px: the known half above and to the left decides.</source>
        <translation>Ligne par ligne à une seule échelle, avec des voisinages de 5, 9, 15 et 21 px : la moitié connue, au-dessus et à gauche, décide.</translation>
    </message>
    <message>
        <source>STMap</source>
        <translation>STMap</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Échelle</translation>
    </message>
    <message>
        <source>Share of a piece over which neighbours overlap, for cuts and feathering: larger joins better.</source>
        <translation>Part d’un morceau sur laquelle les voisins se recouvrent, pour les coupes et le fondu : plus grand raccorde mieux.</translation>
    </message>
    <message>
        <source>Share of the variance in them</source>
        <translation>Leur part de la variance</translation>
    </message>
    <message>
        <source>Shuffling pieces</source>
        <translation>Mélange des morceaux</translation>
    </message>
    <message>
        <source>Side of a piece, or width of a slice: larger keeps larger structures whole, smaller makes outputs differ more.</source>
        <translation>Côté d’un morceau ou largeur d’une tranche : plus grand garde entières de plus grandes structures, plus petit rend les sorties plus différentes.</translation>
    </message>
    <message>
        <source>Side of the patches at each scale: larger keeps larger features whole and takes longer.</source>
        <translation>Côté des patches à chaque échelle : plus grand garde entiers de plus grands motifs et dure plus longtemps.</translation>
    </message>
    <message>
        <source>Side of the squares that are copied; 0 chooses by the exemplar and its lattice. Larger keeps larger stretches, smaller varies more. Whole tiles take it where rows do not repeat.</source>
        <translation>Côté des carrés copiés ; 0 choisit selon l’échantillon et son réseau. Plus grand garde de plus grandes étendues, plus petit varie davantage. Les pavés entiers la prennent là où les rangs ne se répètent pas.</translation>
    </message>
    <message>
        <source>Single tiles</source>
        <translation>Pavés isolés</translation>
    </message>
    <message>
        <source>Sinusoid</source>
        <translation>Sinusoïde</translation>
    </message>
    <message>
        <source>Size of the swirls: larger bends slower and moves farther.</source>
        <translation>Taille des tourbillons : plus grande, elle courbe plus lentement et déplace plus loin.</translation>
    </message>
    <message>
        <source>Slices keep what runs along them, as the grain of wood; pieces cut both ways suit what looks alike in all directions; chaos throws blocks over copies of the exemplar.</source>
        <translation>Les tranches gardent ce qui court le long d’elles, comme le fil du bois ; les morceaux coupés dans les deux sens conviennent à ce qui se ressemble dans toutes les directions ; le chaos jette des blocs sur des copies du modèle.</translation>
    </message>
    <message>
        <source>Soft edge</source>
        <translation>Bord adouci</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Espacement</translation>
    </message>
    <message>
        <source>Sparse coding</source>
        <translation>Codage parcimonieux</translation>
    </message>
    <message>
        <source>Sparse synthesis</source>
        <translation>Synthèse parcimonieuse</translation>
    </message>
    <message>
        <source>Sparse synthesis beside statistics</source>
        <translation>Synthèse parcimonieuse à côté des statistiques</translation>
    </message>
    <message>
        <source>Sparse synthesis, as published</source>
        <translation>Synthèse parcimonieuse, comme publiée</translation>
    </message>
    <message>
        <source>Sparse synthesis, larger output</source>
        <translation>Synthèse parcimonieuse, sortie plus grande</translation>
    </message>
    <message>
        <source>Sparse synthesis, micro-texture</source>
        <translation>Synthèse parcimonieuse, micro-texture</translation>
    </message>
    <message>
        <source>Sparse synthesis, step by step</source>
        <translation>Synthèse parcimonieuse, pas à pas</translation>
    </message>
    <message>
        <source>Spectrum</source>
        <translation>Spectre</translation>
    </message>
    <message>
        <source>Steps of the image in each round, between two codings of its patches.</source>
        <translation>Pas de l’image à chaque tour, entre deux codages de ses patches.</translation>
    </message>
    <message>
        <source>Stitching tiles</source>
        <translation>Couture des pavés</translation>
    </message>
    <message>
        <source>Table of tiles</source>
        <translation>Table des pavés</translation>
    </message>
    <message>
        <source>Texture by numbers</source>
        <translation>Texture par numéros</translation>
    </message>
    <message>
        <source>The axis that the first three kinds deform; turbulence deforms both.</source>
        <translation>L’axe que déforment les trois premiers genres ; la turbulence déforme les deux.</translation>
    </message>
    <message>
        <source>The dictionary has patches of {} px, and the patch size is {} px; they need the same.</source>
        <translation>Le dictionnaire a des patches de {} px et la taille du patch est de {} px ; il faut la même.</translation>
    </message>
    <message>
        <source>The dictionary says that it has {} scales of {} channels in patches of {} px.</source>
        <translation>Le dictionnaire annonce {} échelles de {} canaux en patches de {} px.</translation>
    </message>
    <message>
        <source>The dictionary&apos;s counts of uses at scale {} make no sense.</source>
        <translation>Les nombres d’utilisations du dictionnaire à l’échelle {} n’ont pas de sens.</translation>
    </message>
    <message>
        <source>The exemplar itself, as published, gives its own layout of light and dark, and is only possible at its size; random phases give a new one at any size. Whatever fits takes the exemplar where sizes are the same and nothing wraps.</source>
        <translation>L’échantillon lui-même, comme publié, donne sa propre disposition de clair et de sombre et n’est possible qu’à sa taille ; des phases aléatoires en donnent une nouvelle à toute taille. Ce qui convient prend l’échantillon là où les tailles sont égales et où rien ne se raccorde.</translation>
    </message>
    <message>
        <source>The exemplar&apos;s own low frequencies fit an output of its size, {} × {} px, and this one is {} × {} px; choose random phases.</source>
        <translation>Les basses fréquences de l’échantillon conviennent à une sortie de sa taille, {} × {} px, et celle-ci fait {} × {} px ; choisissez des phases aléatoires.</translation>
    </message>
    <message>
        <source>The first three stretch and squeeze along one axis; turbulence swirls along both.</source>
        <translation>Les trois premières étirent et compriment le long d’un axe ; la turbulence tourbillonne le long des deux.</translation>
    </message>
    <message>
        <source>The hole is filled with patches of {} px: larger ones would cover most of it.</source>
        <translation>Le trou est rempli de pièces de {} px : de plus grandes en couvriraient la plus grande partie.</translation>
    </message>
    <message>
        <source>The image to start from is {} × {} px, smaller than the patch of {} px; choose a patch of at most {} px.</source>
        <translation>L’image de départ fait {} × {} px, moins que la pièce de {} px ; choisissez une pièce d’au plus {} px.</translation>
    </message>
    <message>
        <source>The lattice&apos;s tile of {} × {} px does not fit into {} of {} × {} px; choose unit=blocks.</source>
        <translation>Le pavé du réseau de {} × {} px ne tient pas dans {} de {} × {} px ; choisissez unit=blocks.</translation>
    </message>
    <message>
        <source>The learnt atoms of each scale, and how often each is used.</source>
        <translation>Les atomes appris de chaque échelle, et combien de fois chacun est utilisé.</translation>
    </message>
    <message>
        <source>The map&apos;s pixel ({}, {}) comes from exemplar {}, but there are {}.</source>
        <translation>Le pixel ({}, {}) de la carte vient du modèle {}, mais il y en a {}.</translation>
    </message>
    <message>
        <source>The mask hides all of the exemplar; leave some of it to lay, at least {} px.</source>
        <translation>Le masque cache tout le modèle ; laissez-en une partie à poser, au moins {} px.</translation>
    </message>
    <message>
        <source>The mask leaves no whole block of {} px to lay; choose smaller blocks or mask less.</source>
        <translation>Le masque ne laisse aucun bloc entier de {} px à poser ; choisissez des blocs plus petits ou masquez moins.</translation>
    </message>
    <message>
        <source>The mask leaves no whole piece of {} px to lay; choose smaller pieces or mask less.</source>
        <translation>Le masque ne laisse aucun morceau entier de {} px à poser ; choisissez des morceaux plus petits ou masquez moins.</translation>
    </message>
    <message>
        <source>The mask leaves no whole tile of {} × {} px to copy; mask less, or choose unit=blocks.</source>
        <translation>Le masque ne laisse aucun pavé entier de {} × {} px à copier ; masquez moins, ou choisissez unit=blocks.</translation>
    </message>
    <message>
        <source>The model has no array {} with atoms in it.</source>
        <translation>Le modèle n’a pas de tableau {} contenant des atomes.</translation>
    </message>
    <message>
        <source>The same exemplar with windows of 5, 9, 15 and 25 px: too small a window grows garbage, too large a one copies verbatim.</source>
        <translation>Le même échantillon avec des fenêtres de 5, 9, 15 et 25 px : trop petite, elle produit n’importe quoi ; trop grande, elle copie mot à mot.</translation>
    </message>
    <message>
        <source>The spacing of {} px leaves gaps between patches of {} px; choose at most {} px.</source>
        <translation>L’espacement de {} px laisse des vides entre des patches de {} px ; choisissez au plus {} px.</translation>
    </message>
    <message>
        <source>The waves alone, of the output&apos;s size: the texture without its irregularities.</source>
        <translation>Les ondes seules, à la taille de la sortie : la texture sans ses irrégularités.</translation>
    </message>
    <message>
        <source>Three methods, pixel by pixel</source>
        <translation>Trois méthodes, pixel par pixel</translation>
    </message>
    <message>
        <source>Tile sheet</source>
        <translation>Planche de pavés</translation>
    </message>
    <message>
        <source>Tile with overlap, height</source>
        <translation>Pavé avec recouvrement, hauteur</translation>
    </message>
    <message>
        <source>Tile with overlap, width</source>
        <translation>Pavé avec recouvrement, largeur</translation>
    </message>
    <message>
        <source>Tiles stitched</source>
        <translation>Pavés cousus</translation>
    </message>
    <message>
        <source>Turbulence</source>
        <translation>Turbulence</translation>
    </message>
    <message>
        <source>Turn pieces</source>
        <translation>Tourner les morceaux</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unité</translation>
    </message>
    <message>
        <source>Varied</source>
        <translation>Variées</translation>
    </message>
    <message>
        <source>Waves of the sinusoid over the whole: more of them move less far.</source>
        <translation>Ondes de la sinusoïde sur l’ensemble : plus nombreuses, elles déplacent moins loin.</translation>
    </message>
    <message>
        <source>Weight of low frequencies</source>
        <translation>Poids des basses fréquences</translation>
    </message>
    <message>
        <source>Weight of the histogram</source>
        <translation>Poids de l’histogramme</translation>
    </message>
    <message>
        <source>Weight of the spectrum</source>
        <translation>Poids du spectre</translation>
    </message>
    <message>
        <source>Wei–Levoy on one scale</source>
        <translation>Wei–Levoy à une seule échelle</translation>
    </message>
    <message>
        <source>Wei–Levoy, Ashikhmin and image analogies on one exemplar: the first blurs small things, the second shows joins, the third weighs one against the other.</source>
        <translation>Wei–Levoy, Ashikhmin et analogies d’images sur un échantillon : la première estompe les petites choses, la deuxième montre des raccords, la troisième fait la part des deux.</translation>
    </message>
    <message>
        <source>Whatever fits</source>
        <translation>Ce qui convient</translation>
    </message>
    <message>
        <source>Where a hole is filled, how far around it the same picture is copied from: smaller takes what is near, and is faster; 0 takes all of the picture.</source>
        <translation>Là où un trou est rempli, jusqu’à quelle distance autour de lui la même image est copiée : plus petit prend ce qui est proche, et plus vite ; 0 prend toute l’image.</translation>
    </message>
    <message>
        <source>Where a hole is filled, how far from its own place in an exemplar of the output&apos;s size a pixel&apos;s source may lie: smaller takes what is near; 0 looks everywhere.</source>
        <translation>Là où un trou est rempli, à quelle distance de sa propre place, dans un échantillon de la taille de la sortie, la source d’un pixel peut se trouver : plus petit prend ce qui est proche ; 0 cherche partout.</translation>
    </message>
    <message>
        <source>Where each pixel comes from, between pixels too, as compositors read it: .exr, of 32-bit floats. `apply` lays out another map by it.</source>
        <translation>D’où vient chaque pixel, aussi entre les pixels, comme les logiciels de compositing le lisent : .exr, en flottants 32 bits. `apply` dispose une autre carte d’après elle.</translation>
    </message>
    <message>
        <source>Where each pixel of the sheet comes from: `apply` makes the same sheet of companion maps with it.</source>
        <translation>D’où vient chaque pixel de la planche : `apply` en fait la même planche des cartes associées.</translation>
    </message>
    <message>
        <source>Whole tiles</source>
        <translation>Pavés entiers</translation>
    </message>
    <message>
        <source>With the exemplar&apos;s spectrum, which brings back the fine grain of grass, sand or cloth that few atoms cannot code.</source>
        <translation>Avec le spectre de l’échantillon, qui rend le grain fin de l’herbe, du sable ou du tissu, que peu d’atomes ne peuvent coder.</translation>
    </message>
    <message>
        <source>picture</source>
        <translation>image</translation>
    </message>
    <message>
        <source>{} cannot hold an STMap, which needs 32-bit floats; its name ends in .exr.</source>
        <translation>{} ne peut contenir une STMap, qui demande des flottants 32 bits ; son nom finit par .exr.</translation>
    </message>
    <message>
        <source>{} declares {} for its output {}, but made something else; this is a mistake in the method.</source>
        <translation>{} annonce {} pour sa sortie {}, mais a produit autre chose ; c’est une erreur dans la méthode.</translation>
    </message>
    <message>
        <source>{} gives {} to {} for its output {}, but made {}; this is a mistake in the method.</source>
        <translation>{} fournit de {} à {} éléments pour sa sortie {}, mais en a produit {} ; c’est une erreur dans la méthode.</translation>
    </message>
    <message>
        <source>{} holds only one whole tile, so that nothing varies; a larger exemplar or a smaller tile shows how tiles differ.</source>
        <translation>{} ne contient qu’un pavé entier, donc rien ne varie ; un échantillon plus grand ou un pavé plus petit montre en quoi les pavés diffèrent.</translation>
    </message>
    <message>
        <source>{} is one piece of this size, so that the output only repeats it; choose pieces of at most {} px.</source>
        <translation>{} est un seul morceau de cette taille, si bien que la sortie ne fait que le répéter ; choisissez des morceaux d’au plus {} px.</translation>
    </message>
    <message>
        <source>{} is {} × {} px, smaller than a piece of {} px; choose pieces of at most {} px.</source>
        <translation>{} fait {} × {} px, moins qu’un morceau de {} px ; choisissez des morceaux d’au plus {} px.</translation>
    </message>
    <message>
        <source>{} learns from no exemplar, so that it makes no companion maps; leave them out.</source>
        <translation>{} n’apprend d’aucun échantillon et ne produit donc pas de cartes associées ; omettez-les.</translation>
    </message>
    <message>
        <source>{} made a model of the kind {} for its output {}, which takes one of its own kind; this is a mistake in the method.</source>
        <translation>{} a produit un modèle du type {} pour sa sortie {}, qui en demande un de son propre type ; c’est une erreur dans la méthode.</translation>
    </message>
    <message>
        <source>{} made an output {} that it does not declare; this is a mistake in the method.</source>
        <translation>{} a produit une sortie {} qu’elle n’annonce pas ; c’est une erreur dans la méthode.</translation>
    </message>
    <message>
        <source>Algorithm 1 of Gutierrez&apos; thesis: the whole assignment at 3 scales with 50, 50 and 10 rounds, medians by Douglas–Rachford splitting. Hours and gigabytes for large outputs.</source>
        <translation>L’algorithme 1 de la thèse de Gutierrez : l’affectation entière à 3 échelles avec 50, 50 et 10 tours, médianes par éclatement de Douglas–Rachford. Des heures et des gigaoctets pour de grandes sorties.</translation>
    </message>
    <message>
        <source>All channels together</source>
        <translation>Tous les canaux ensemble</translation>
    </message>
    <message>
        <source>As the source prints it: channels may choose differently.</source>
        <translation>Comme la source l’imprime : les canaux peuvent choisir différemment.</translation>
    </message>
    <message>
        <source>At this size every patch chose among a few that suit it, so some are used a little more often than others; the setting “Solved” = Whole takes much longer and uses all as they should be.</source>
        <translation>À cette taille, chaque morceau a choisi parmi quelques-uns qui lui conviennent ; certains sont donc employés un peu plus souvent que d’autres. Le réglage « Résolution » = Entière prend bien plus de temps et les emploie tous comme il se doit.</translation>
    </message>
    <message>
        <source>Black where the second image is cloned. Without it, that is the middle half of its width and height.</source>
        <translation>Noir là où la seconde image est clonée. Sans lui, c’est la moitié centrale de sa largeur et de sa hauteur.</translation>
    </message>
    <message>
        <source>Border of the first</source>
        <translation>Bord de la première</translation>
    </message>
    <message>
        <source>Choosing gradients</source>
        <translation>Choix des gradients</translation>
    </message>
    <message>
        <source>Clone seamlessly</source>
        <translation>Cloner sans raccord</translation>
    </message>
    <message>
        <source>Closed</source>
        <translation>Fermé</translation>
    </message>
    <message>
        <source>Conditional Gaussian, as published</source>
        <translation>Gaussien conditionnel, comme publié</translation>
    </message>
    <message>
        <source>Constant tolerance</source>
        <translation>Tolérance constante</translation>
    </message>
    <message>
        <source>Each channel for itself</source>
        <translation>Chaque canal séparément</translation>
    </message>
    <message>
        <source>Each channel takes its own stronger gradient, as printed; otherwise the length over all channels decides for the pixel, so that no false colours appear.</source>
        <translation>Chaque canal prend son propre gradient le plus fort, comme imprimé ; sinon la longueur sur tous les canaux décide pour le pixel, sans fausses couleurs.</translation>
    </message>
    <message>
        <source>Every patch chose among a few that suit it, as asked, so some are used a little more often than others.</source>
        <translation>Chaque morceau a choisi, comme demandé, parmi quelques-uns qui lui conviennent ; certains sont donc employés un peu plus souvent que d’autres.</translation>
    </message>
    <message>
        <source>Factor on the first image&apos;s gradients before they are compared: larger keeps more of the first image.</source>
        <translation>Facteur sur les gradients de la première image avant la comparaison : plus grand garde plus de la première image.</translation>
    </message>
    <message>
        <source>Free, mean of the first</source>
        <translation>Libre, moyenne de la première</translation>
    </message>
    <message>
        <source>Gaussian patches, as published</source>
        <translation>Morceaux gaussiens, comme publié</translation>
    </message>
    <message>
        <source>Goes on over the border, for images that wrap.</source>
        <translation>Continue par-delà le bord, pour des images qui se referment.</translation>
    </message>
    <message>
        <source>How far below its place in the second image the region comes to lie in the first.</source>
        <translation>De combien la région se place dans la première image au-dessous de sa place dans la seconde.</translation>
    </message>
    <message>
        <source>How far right of its place in the second image the region comes to lie in the first.</source>
        <translation>De combien la région se place dans la première image à droite de sa place dans la seconde.</translation>
    </message>
    <message>
        <source>How overlapping patches are joined: the geometric median (r = 1) as published, the mean (r = 2), which blurs, or robust weights (r = 0.8).</source>
        <translation>Comment les morceaux qui se chevauchent sont joints : la médiane géométrique (r = 1), comme publié, la moyenne (r = 2), qui rend flou, ou des poids robustes (r = 0,8).</translation>
    </message>
    <message>
        <source>How patches are assigned: whole, as published, uses every patch as often as it should be and may take hours and gigabytes for large outputs; narrowed lets each patch choose among a few; automatic is whole up to some minutes.</source>
        <translation>Comment les morceaux sont affectés : entière, comme publié, emploie chaque morceau aussi souvent qu’il le faut et peut prendre des heures et des gigaoctets pour de grandes sorties ; restreinte laisse chaque morceau choisir parmi quelques-uns ; automatique est entière jusqu’à quelques minutes.</translation>
    </message>
    <message>
        <source>How the most similar patch is found: exactly, or nearly and faster with large exemplars. With uniformity, always exactly.</source>
        <translation>Comment le morceau le plus semblable est trouvé : exactement, ou à peu près et plus vite avec de grands échantillons. Avec l’uniformité, toujours exactement.</translation>
    </message>
    <message>
        <source>Joining gradients</source>
        <translation>Assemblage des gradients</translation>
    </message>
    <message>
        <source>Keeps the tolerance as it is on the finest scale, as published, where it otherwise falls from round to round.</source>
        <translation>Garde la tolérance telle quelle à l’échelle la plus fine, comme publié, alors qu’elle y baisse sinon d’un tour à l’autre.</translation>
    </message>
    <message>
        <source>Kwatra et al. as Gutierrez&apos; thesis, section 3.1, gives it: patches of 32, 16 and 8 px at 3 scales, robust weights with a Gaussian falloff, no uniformity.</source>
        <translation>Kwatra et al. selon la thèse de Gutierrez, section 3.1 : morceaux de 32, 16 et 8 px à 3 échelles, poids robustes avec atténuation gaussienne, sans uniformité.</translation>
    </message>
    <message>
        <source>Lays the structure of one image over another: each pixel gets the stronger of the two gradients. Suits a plain material and one with marks of the same kind.</source>
        <translation>Pose la structure d’une image sur une autre : chaque pixel reçoit le plus fort des deux gradients. Convient à un matériau sobre et à un autre du même genre qui porte des marques.</translation>
    </message>
    <message>
        <source>Locally Gaussian, as published</source>
        <translation>Localement gaussien, comme publié</translation>
    </message>
    <message>
        <source>Midway quilting, as published</source>
        <translation>Quilting midway, comme publié</translation>
    </message>
    <message>
        <source>Mix by gradients</source>
        <translation>Mêler par gradients</translation>
    </message>
    <message>
        <source>Mixed</source>
        <translation>Mêlée</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Mode</translation>
    </message>
    <message>
        <source>Moved by {}, {} px, the region of the second image does not lie over the first of {} × {} px; move it less, or paint it elsewhere.</source>
        <translation>Déplacée de {}, {} px, la région de la seconde image n’est pas sur la première de {} × {} px ; déplacez-la moins, ou peignez-la ailleurs.</translation>
    </message>
    <message>
        <source>Moved down</source>
        <translation>Décalage vers le bas</translation>
    </message>
    <message>
        <source>Moved right</source>
        <translation>Décalage à droite</translation>
    </message>
    <message>
        <source>Multiscale Gaussian, as published</source>
        <translation>Gaussien multi-échelle, comme publié</translation>
    </message>
    <message>
        <source>Narrowed</source>
        <translation>Restreinte</translation>
    </message>
    <message>
        <source>Near-regular, as published</source>
        <translation>Presque régulier, comme publié</translation>
    </message>
    <message>
        <source>Pasted</source>
        <translation>Collée</translation>
    </message>
    <message>
        <source>Patch assignment, as published</source>
        <translation>Affectation de morceaux, comme publié</translation>
    </message>
    <message>
        <source>Patches used beyond their share</source>
        <translation>Morceaux employés au-delà de leur part</translation>
    </message>
    <message>
        <source>Preference</source>
        <translation>Préférence</translation>
    </message>
    <message>
        <source>Puts a region of the second image into the first one, so that no seam shows: its structure comes along, its light and colour are those around it.</source>
        <translation>Met une région de la seconde image dans la première sans raccord visible : sa structure l’accompagne, sa lumière et sa couleur sont celles du voisinage.</translation>
    </message>
    <message>
        <source>Quilting, as published</source>
        <translation>Quilting, comme publié</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>Région</translation>
    </message>
    <message>
        <source>Regular tile, as published</source>
        <translation>Carreau régulier, comme publié</translation>
    </message>
    <message>
        <source>Replaced</source>
        <translation>Remplacée</translation>
    </message>
    <message>
        <source>Settled at</source>
        <translation>Stabilisé à</translation>
    </message>
    <message>
        <source>Solved</source>
        <translation>Résolution</translation>
    </message>
    <message>
        <source>Texture optimisation, as published</source>
        <translation>Optimisation de texture, comme publié</translation>
    </message>
    <message>
        <source>That of the first</source>
        <translation>Celui de la première</translation>
    </message>
    <message>
        <source>The experiment of Raad&apos;s thesis, figure 2.1: patches of 30 px from 10 neighbours, contrast not balanced.</source>
        <translation>L’expérience de la thèse de Raad, figure 2.1 : morceaux de 30 px à partir de 10 voisins, contraste non équilibré.</translation>
    </message>
    <message>
        <source>The longer gradient over all channels: no colour that neither image has.</source>
        <translation>Le gradient le plus long sur tous les canaux : aucune couleur absente des deux images.</translation>
    </message>
    <message>
        <source>The mask is {} × {} px, the second image {} × {} px; paint it on that image.</source>
        <translation>Le masque fait {} × {} px, la seconde image {} × {} px ; peignez-le sur cette image.</translation>
    </message>
    <message>
        <source>The pixels as they are, to compare with.</source>
        <translation>Les pixels tels quels, pour comparer.</translation>
    </message>
    <message>
        <source>The pixels at the border stay as they are in the first image.</source>
        <translation>Les pixels du bord restent ceux de la première image.</translation>
    </message>
    <message>
        <source>The region covers all of the first image of {} × {} px, so that there is nothing to join it with; paint a smaller one.</source>
        <translation>La région couvre toute la première image de {} × {} px, il n’y a donc rien à quoi la joindre ; peignez-en une plus petite.</translation>
    </message>
    <message>
        <source>The rule of López Recas 2011, section 4.1: the tile that joins itself best, compared over borders of 2 × 8 px.</source>
        <translation>La règle de López Recas 2011, section 4.1 : le carreau qui se raccorde le mieux à lui-même, comparé sur des bords de 2 × 8 px.</translation>
    </message>
    <message>
        <source>The settings of López Recas 2011, section 4.2: blocks of 40 px with borders of 10 px, blended over 4 px, light left as it is.</source>
        <translation>Les réglages de López Recas 2011, section 4.2 : blocs de 40 px avec des bords de 10 px, fondus sur 4 px, lumière laissée telle quelle.</translation>
    </message>
    <message>
        <source>The settings of Raad&apos;s thesis, figure 2.6: patches of 30 px from 10 neighbours joined along cuts, contrast not balanced.</source>
        <translation>Les réglages de la thèse de Raad, figure 2.6 : morceaux de 30 px à partir de 10 voisins, joints le long de coupes, contraste non équilibré.</translation>
    </message>
    <message>
        <source>The settings of Raad&apos;s thesis, figure 3.4: patches of 40 px from 30 neighbours that overlap by half, contrast not balanced. Fades on most photographs, as the source says.</source>
        <translation>Les réglages de la thèse de Raad, figure 3.4 : morceaux de 40 px à partir de 30 voisins qui se chevauchent de moitié, contraste non équilibré. S’efface sur la plupart des photographies, comme le dit la source.</translation>
    </message>
    <message>
        <source>The settings of Raad&apos;s thesis, figure 3.5: patches of 20 px from 50 neighbours at 3 scales, averaged at the coarsest and pasted at the others, contrast not balanced.</source>
        <translation>Les réglages de la thèse de Raad, figure 3.5 : morceaux de 20 px à partir de 50 voisins à 3 échelles, moyennés à la plus grossière et collés aux autres, contraste non équilibré.</translation>
    </message>
    <message>
        <source>The settings of Raad&apos;s thesis, figure 4.21: patches of 40 px that overlap by 0.45, contrast not balanced.</source>
        <translation>Les réglages de la thèse de Raad, figure 4.21 : morceaux de 40 px avec un recouvrement de 0,45, contraste non équilibré.</translation>
    </message>
    <message>
        <source>The stronger structure of both, so that the first shows through.</source>
        <translation>La structure la plus forte des deux, si bien que la première transparaît.</translation>
    </message>
    <message>
        <source>The structure of the second image alone.</source>
        <translation>La structure de la seconde image seule.</translation>
    </message>
    <message>
        <source>What holds at the border: nothing, and the mean is that of the first image; the pixels of the first image; or that the image closes on itself.</source>
        <translation>Ce qui vaut au bord : rien, et la moyenne est celle de la première image ; les pixels de la première image ; ou que l’image se referme.</translation>
    </message>
    <message>
        <source>Whole</source>
        <translation>Entière</translation>
    </message>
    <message>
        <source>Whose gradients fill the region: those of the second image, the stronger ones of both, or none: pixels are pasted.</source>
        <translation>De qui viennent les gradients de la région : de la seconde image, les plus forts des deux, ou aucun : les pixels sont collés.</translation>
    </message>
    <message>
        <source>With a tolerance or relaxed: rounds end when the cost falls by less than this share; 0 goes on to the last round, as published.</source>
        <translation>Avec une tolérance ou relâché : les tours s’arrêtent quand le coût baisse de moins que cette part ; 0 va jusqu’au dernier tour, comme publié.</translation>
    </message>
    <message>
        <source>The system gives the program no further thread; raise its limits (ulimit -v and -u), or use fewer threads.</source>
        <translation>Le système ne donne plus de fil d’exécution au programme ; relevez ses limites (ulimit -v et -u) ou utilisez moins de fils.</translation>
    </message>
    <message>
        <source>A descriptor&apos;s file is given and another descriptor chosen: choose automatic, or leave the file out.</source>
        <translation>Un fichier de descripteur est donné et un autre descripteur choisi : choisissez « automatique » ou retirez le fichier.</translation>
    </message>
    <message>
        <source>A layer of the network takes {} channels of at least {}×{} px, and has {} of {}×{} px.</source>
        <translation>Une couche du réseau prend {} canaux d&apos;au moins {}×{} px et en a {} de {}×{} px.</translation>
    </message>
    <message>
        <source>A network of your own, such as one that import-descriptor or learn-descriptor made.</source>
        <translation>Un réseau à vous, par exemple issu de import-descriptor ou de learn-descriptor.</translation>
    </message>
    <message>
        <source>A normal map needs 3 channels, and this one has {}; choose another map, or say what it holds.</source>
        <translation>Une carte de normales demande 3 canaux, et celle-ci en a {} ; choisissez une autre carte ou dites ce qu’elle contient.</translation>
    </message>
    <message>
        <source>A panorama needs 3 channels of light, and this one has {}; choose another picture.</source>
        <translation>Un panorama demande 3 canaux de lumière, et celui-ci en a {} ; choisissez une autre image.</translation>
    </message>
    <message>
        <source>A point at {} lies too far out; coordinates go from −{} to {}.</source>
        <translation>Un point en {} est trop loin ; les coordonnées vont de −{} à {}.</translation>
    </message>
    <message>
        <source>A solid of {} voxels a side holds no neighbourhood of {}.</source>
        <translation>Un solide de {} voxels de côté ne contient aucun voisinage de {}.</translation>
    </message>
    <message>
        <source>A step gave values that are not numbers: the optimisation ended with the last that are.</source>
        <translation>Un pas a donné des valeurs qui ne sont pas des nombres : l&apos;optimisation s&apos;est arrêtée aux dernières qui en sont.</translation>
    </message>
    <message>
        <source>A trained generator to go on from.</source>
        <translation>Un générateur entraîné à partir duquel continuer.</translation>
    </message>
    <message>
        <source>Adam</source>
        <translation>Adam</translation>
    </message>
    <message>
        <source>All three axes are free, so that nothing is wanted of the solid; give one of them an exemplar and a weight.</source>
        <translation>Les trois axes sont libres, de sorte que rien n’est demandé au solide ; donnez à l’un d’eux un échantillon et un poids.</translation>
    </message>
    <message>
        <source>All {} × {} px of the image to start from are known, so that there is nothing to make; mask less.</source>
        <translation>Les {} × {} px de l’image de départ sont tous connus : il n’y a rien à faire ; masquez moins.</translation>
    </message>
    <message>
        <source>Also compares the distribution of colours, which networks alone let drift.</source>
        <translation>Compare aussi la répartition des couleurs, que les réseaux seuls laissent dériver.</translation>
    </message>
    <message>
        <source>An exemplar of {}×{} px is too small for the network, which needs {} px a side.</source>
        <translation>Un échantillon de {}×{} px est trop petit pour le réseau, qui demande {} px par côté.</translation>
    </message>
    <message>
        <source>Anamorphosis: bending what repeats</source>
        <translation>Anamorphose : courber ce qui se répète</translation>
    </message>
    <message>
        <source>As it is</source>
        <translation>Tel quel</translation>
    </message>
    <message>
        <source>As the descriptor says</source>
        <translation>Comme le dit le descripteur</translation>
    </message>
    <message>
        <source>At each scale: more come closer to the exemplar and take longer.</source>
        <translation>À chaque échelle : davantage s&apos;approche mieux de l&apos;échantillon et dure plus longtemps.</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Changement</translation>
    </message>
    <message>
        <source>Changes noise, or an initial image, until the feature maps of a network vary together as the exemplar&apos;s do. New pixels rather than copies; long straight structures may bend or break.</source>
        <translation>Modifie un bruit, ou une image de départ, jusqu&apos;à ce que les cartes de caractéristiques d&apos;un réseau varient ensemble comme celles de l&apos;échantillon. De nouveaux pixels plutôt que des copies ; les longues structures droites peuvent plier ou se rompre.</translation>
    </message>
    <message>
        <source>Compare colours</source>
        <translation>Comparer les couleurs</translation>
    </message>
    <message>
        <source>Cutting a slice</source>
        <translation>Découpe d’une tranche</translation>
    </message>
    <message>
        <source>Descriptor</source>
        <translation>Descripteur</translation>
    </message>
    <message>
        <source>Descriptor: {} (licence {}; {}; SHA-1 {}).</source>
        <translation>Descripteur : {} (licence {} ; {} ; SHA-1 {}).</translation>
    </message>
    <message>
        <source>Distance of neighbourhoods</source>
        <translation>Distance des voisinages</translation>
    </message>
    <message>
        <source>Even tone</source>
        <translation>Égaliser le ton</translation>
    </message>
    <message>
        <source>Evening tone</source>
        <translation>Égalisation du ton</translation>
    </message>
    <message>
        <source>Exemplar&apos;s side</source>
        <translation>Côté de l’échantillon</translation>
    </message>
    <message>
        <source>Exemplars with a longer side are scaled down to this: smaller makes features smaller, so that a solid holds more of them.</source>
        <translation>Les échantillons d’un côté plus long y sont ramenés : plus petit rend les motifs plus petits, de sorte qu’un solide en contient davantage.</translation>
    </message>
    <message>
        <source>Figure 5.42 of Raad&apos;s thesis on free exemplars: metal and rock with random low frequencies. Where high and low frequencies go together, as here, it shows.</source>
        <translation>La figure 5.42 de la thèse de Raad sur des échantillons libres : métal et roche aux basses fréquences aléatoires. Là où hautes et basses fréquences vont ensemble, comme ici, cela se voit.</translation>
    </message>
    <message>
        <source>Figures 5.31 to 5.35 of Raad&apos;s thesis on free exemplars: wood and rock bent along one axis and along both. From farther away they remain much alike.</source>
        <translation>Les figures 5.31 à 5.35 de la thèse de Raad sur des échantillons libres : bois et roche courbés selon un axe et selon les deux. De plus loin, ils restent très semblables.</translation>
    </message>
    <message>
        <source>First</source>
        <translation>Premier</translation>
    </message>
    <message>
        <source>First tap</source>
        <translation>Première prise</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>Libre</translation>
    </message>
    <message>
        <source>Generator</source>
        <translation>Générateur</translation>
    </message>
    <message>
        <source>Gives all exemplars the colours of the first, without which slices of two kinds cannot agree where they cross.</source>
        <translation>Donne à tous les échantillons les couleurs du premier, sans quoi des coupes de deux sortes ne peuvent s’accorder là où elles se croisent.</translation>
    </message>
    <message>
        <source>Gives the result the exemplar&apos;s distribution of colours at the end.</source>
        <translation>Donne à la fin au résultat la répartition des couleurs de l&apos;échantillon.</translation>
    </message>
    <message>
        <source>Gram</source>
        <translation>Gram</translation>
    </message>
    <message>
        <source>Gram matrices of a network</source>
        <translation>Matrices de Gram d&apos;un réseau</translation>
    </message>
    <message>
        <source>Half</source>
        <translation>Demi-tour</translation>
    </message>
    <message>
        <source>How far Adam moves in one step, in deviations of the exemplar&apos;s colours: larger is faster and less exact.</source>
        <translation>De combien Adam avance en un pas, en écarts des couleurs de l&apos;échantillon : plus grand est plus rapide et moins exact.</translation>
    </message>
    <message>
        <source>How far each step goes at the beginning; it falls to a twentieth. Too large, and the loss jumps; too small, and it falls slowly.</source>
        <translation>Longueur de chaque pas au début ; elle tombe à un vingtième. Trop grande, la perte saute ; trop petite, elle baisse lentement.</translation>
    </message>
    <message>
        <source>How much rough pixels are avoided: more smooths noise and fine detail alike.</source>
        <translation>À quel point les pixels rugueux sont évités : davantage lisse le bruit comme les détails fins.</translation>
    </message>
    <message>
        <source>How much the distribution of small patches counts, which makes edges sharper; 0 leaves it to the descriptor.</source>
        <translation>Combien compte la distribution des petits morceaux, qui rend les bords plus nets ; 0 s’en remet au descripteur.</translation>
    </message>
    <message>
        <source>How much the features count that the descriptor sees in slices; 0 compares patches alone.</source>
        <translation>Combien comptent les caractéristiques que le descripteur voit dans les coupes ; 0 ne compare que des morceaux.</translation>
    </message>
    <message>
        <source>How much these slices count beside the others; 0 leaves the axis free.</source>
        <translation>Combien ces coupes comptent à côté des autres ; 0 laisse l’axe libre.</translation>
    </message>
    <message>
        <source>How the exemplar is turned in these slices; where they meet, patterns must agree.</source>
        <translation>Comment l’échantillon est tourné dans ces coupes ; là où elles se croisent, les motifs doivent s’accorder.</translation>
    </message>
    <message>
        <source>How the network halves its feature maps: by their mean, or by the largest of four values.</source>
        <translation>Comment le réseau réduit de moitié ses cartes : par leur moyenne ou par la plus grande de quatre valeurs.</translation>
    </message>
    <message>
        <source>How the weights of a patch&apos;s atoms are found: plain, as published, adds one atom after another; orthogonal finds all weights again with every atom, which follows the patch more closely and takes a little longer.</source>
        <translation>Comment sont trouvés les poids des atomes d’un patch : simple, comme publié, ajoute un atome après l’autre ; orthogonale retrouve tous les poids à chaque atome, suit le patch de plus près et prend un peu plus de temps.</translation>
    </message>
    <message>
        <source>L-BFGS</source>
        <translation>L-BFGS</translation>
    </message>
    <message>
        <source>L-BFGS learns the curvature of the loss and comes further in as many iterations; Adam takes steps of one length.</source>
        <translation>L-BFGS apprend la courbure de la perte et va plus loin en autant d&apos;itérations ; Adam fait des pas d&apos;une même longueur.</translation>
    </message>
    <message>
        <source>Last tap</source>
        <translation>Dernière prise</translation>
    </message>
    <message>
        <source>Learned from the exemplar</source>
        <translation>Appris de l&apos;échantillon</translation>
    </message>
    <message>
        <source>Learning rate</source>
        <translation>Taux d’apprentissage</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>À gauche</translation>
    </message>
    <message>
        <source>Levels</source>
        <translation>Niveaux</translation>
    </message>
    <message>
        <source>Loss</source>
        <translation>Perte</translation>
    </message>
    <message>
        <source>Low frequencies: three of each</source>
        <translation>Basses fréquences : trois de chaque</translation>
    </message>
    <message>
        <source>Makes a solid block that repeats in all directions and whose slices look like the exemplar, or like one exemplar for each direction. The picture is its slice at z = 0.</source>
        <translation>Fait un bloc qui se répète dans toutes les directions et dont les coupes ressemblent à l’échantillon, ou à un échantillon par direction. L’image en est la coupe en z = 0.</translation>
    </message>
    <message>
        <source>Match histograms</source>
        <translation>Égaliser les histogrammes</translation>
    </message>
    <message>
        <source>Matching feature maps</source>
        <translation>Ajustement des cartes de caractéristiques</translation>
    </message>
    <message>
        <source>Matching neighbourhoods</source>
        <translation>Appariement des voisinages</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>Maximum</translation>
    </message>
    <message>
        <source>Mirrored</source>
        <translation>En miroir</translation>
    </message>
    <message>
        <source>Mirrored, half</source>
        <translation>En miroir, demi-tour</translation>
    </message>
    <message>
        <source>Mirrored, left</source>
        <translation>En miroir, à gauche</translation>
    </message>
    <message>
        <source>Mirrored, right</source>
        <translation>En miroir, à droite</translation>
    </message>
    <message>
        <source>Move seams</source>
        <translation>Coutures mobiles</translation>
    </message>
    <message>
        <source>Moving seams</source>
        <translation>Déplacement des coutures</translation>
    </message>
    <message>
        <source>Neighbourhoods</source>
        <translation>Voisinages</translation>
    </message>
    <message>
        <source>Normalised</source>
        <translation>Normalisée</translation>
    </message>
    <message>
        <source>Nothing of the image to start from, {} × {} px, is known, so that there is no hole to fill; leave the mask out, or mark what is to be kept.</source>
        <translation>Rien de l’image de départ, {} × {} px, n’est connu : il n’y a pas de trou à remplir ; omettez le masque ou marquez ce qui doit rester.</translation>
    </message>
    <message>
        <source>Of each direction in one iteration: more make each step surer and longer.</source>
        <translation>De chaque direction dans une itération : davantage rendent chaque pas plus sûr et plus long.</translation>
    </message>
    <message>
        <source>Of the slices that are made and compared: larger ones say more of large features, and take longer.</source>
        <translation>Des coupes qui sont faites et comparées : de plus grandes en disent plus sur les grands motifs, et prennent plus de temps.</translation>
    </message>
    <message>
        <source>Only the patches of slices were compared: the descriptor sees grey pictures and those of three channels.</source>
        <translation>Seuls les morceaux des coupes ont été comparés : le descripteur voit les images grises et celles de trois canaux.</translation>
    </message>
    <message>
        <source>Optimised solid</source>
        <translation>Solide optimisé</translation>
    </message>
    <message>
        <source>Optimiser</source>
        <translation>Optimiseur</translation>
    </message>
    <message>
        <source>Orthogonal</source>
        <translation>Orthogonale</translation>
    </message>
    <message>
        <source>Own</source>
        <translation>Le sien</translation>
    </message>
    <message>
        <source>Plain</source>
        <translation>Simple</translation>
    </message>
    <message>
        <source>Pooling</source>
        <translation>Mise en commun</translation>
    </message>
    <message>
        <source>Preparing the descriptor</source>
        <translation>Préparation du descripteur</translation>
    </message>
    <message>
        <source>Pursuit</source>
        <translation>Poursuite</translation>
    </message>
    <message>
        <source>Pyramid histograms</source>
        <translation>Histogrammes de pyramides</translation>
    </message>
    <message>
        <source>Random filters</source>
        <translation>Filtres aléatoires</translation>
    </message>
    <message>
        <source>Random mosaics: three of each</source>
        <translation>Mosaïques aléatoires : trois de chaque</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Pas</translation>
    </message>
    <message>
        <source>Relative Gram</source>
        <translation>Gram relative</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>À droite</translation>
    </message>
    <message>
        <source>Rounds at each scale: more bring the slices closer to the exemplar.</source>
        <translation>Tours à chaque échelle : davantage rapprochent les coupes de l’échantillon.</translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>Balayage</translation>
    </message>
    <message>
        <source>Scanning</source>
        <translation>Balayage</translation>
    </message>
    <message>
        <source>Second</source>
        <translation>Deuxième</translation>
    </message>
    <message>
        <source>Side of the neighbourhoods compared in slices at each scale: larger keeps larger structures whole and takes longer.</source>
        <translation>Côté des voisinages comparés dans les coupes à chaque échelle : plus grand garde entières de plus grandes structures et prend plus de temps.</translation>
    </message>
    <message>
        <source>Side of the patches that are compared: larger keeps larger structures, smaller varies more. Where a hole is filled, they are half as large again.</source>
        <translation>Côté des patchs comparés : plus grand conserve des structures plus grandes, plus petit varie davantage. Là où un trou est rempli, ils sont plus grands de moitié.</translation>
    </message>
    <message>
        <source>Side of the slices</source>
        <translation>Côté des coupes</translation>
    </message>
    <message>
        <source>Side of the solid</source>
        <translation>Côté du solide</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>Coupes</translation>
    </message>
    <message>
        <source>Slices square to {} are to look like exemplar {}, and there are {}: give it, or choose another one or none.</source>
        <translation>Les coupes perpendiculaires à {} doivent ressembler à l’échantillon {}, et il y en a {} : donnez-le, ou choisissez-en un autre ou aucun.</translation>
    </message>
    <message>
        <source>Solid texture</source>
        <translation>Texture solide</translation>
    </message>
    <message>
        <source>Square to x</source>
        <translation>Perpendiculaire à x</translation>
    </message>
    <message>
        <source>Square to y</source>
        <translation>Perpendiculaire à y</translation>
    </message>
    <message>
        <source>Square to z</source>
        <translation>Perpendiculaire à z</translation>
    </message>
    <message>
        <source>Statistic</source>
        <translation>Statistique</translation>
    </message>
    <message>
        <source>Steps of training: a few hundred show what becomes of it, some thousands make it sharper. It can be stopped at any time and keeps what it has learned.</source>
        <translation>Pas d’entraînement : quelques centaines montrent ce qui en sortira, quelques milliers le rendent plus net. On peut l’arrêter à tout moment, et il garde ce qu’il a appris.</translation>
    </message>
    <message>
        <source>Stopped after {} of {} iterations; the generator knows what it had learned by then.</source>
        <translation>Arrêté après {} itérations sur {} ; le générateur sait ce qu’il avait appris jusque-là.</translation>
    </message>
    <message>
        <source>Texloom&apos;s own</source>
        <translation>Celui de Texloom</translation>
    </message>
    <message>
        <source>The checkpoint does not suit this run: start again without --resume.</source>
        <translation>Le point de reprise ne convient pas à ce calcul : recommencez sans --resume.</translation>
    </message>
    <message>
        <source>The checkpoint holds no solid; start again without it.</source>
        <translation>Le point de reprise ne contient pas de solide ; recommencez sans lui.</translation>
    </message>
    <message>
        <source>The checkpoint is of a generator of another size; start again without it.</source>
        <translation>Le point de reprise est celui d’un générateur d’une autre taille ; recommencez sans lui.</translation>
    </message>
    <message>
        <source>The descriptor cannot be used: {}.</source>
        <translation>Le descripteur est inutilisable : {}.</translation>
    </message>
    <message>
        <source>The descriptor gives values that are not numbers at its tap {}: its weights are too large.</source>
        <translation>Le descripteur donne à sa prise {} des valeurs qui ne sont pas des nombres : ses poids sont trop grands.</translation>
    </message>
    <message>
        <source>The descriptor sees {} channels, and the exemplar has {} with its maps: choose one that sees them all, such as exemplar, random or wavelet.</source>
        <translation>Le descripteur voit {} canaux et l&apos;échantillon en a {} avec ses cartes : choisissez-en un qui les voit tous, tel que exemplar, random ou wavelet.</translation>
    </message>
    <message>
        <source>The descriptor {} sees {} channels, and the exemplar has {}.</source>
        <translation>Le descripteur {} voit {} canaux, et l&apos;échantillon en a {}.</translation>
    </message>
    <message>
        <source>The exemplar has {} × {} px here; its sides must have at least {} px.</source>
        <translation>L’échantillon a ici {} × {} px ; ses côtés doivent avoir au moins {} px.</translation>
    </message>
    <message>
        <source>The exemplar of {}×{} px is too small for the network, which needs {} px a side.</source>
        <translation>L&apos;échantillon de {}×{} px est trop petit pour le réseau, qui demande {} px par côté.</translation>
    </message>
    <message>
        <source>The first layer of the network that is compared; a larger number leaves fine detail free.</source>
        <translation>La première couche du réseau qui est comparée ; un nombre plus grand laisse libres les détails fins.</translation>
    </message>
    <message>
        <source>The first tap is {}, and the descriptor has {}: {}.</source>
        <translation>La première prise est {}, et le descripteur en a {} : {}.</translation>
    </message>
    <message>
        <source>The first tap is {}, which comes after the last, {}.</source>
        <translation>La première prise est {}, après la dernière, {}.</translation>
    </message>
    <message>
        <source>The generator&apos;s array {} holds {}; variances are not below 0.</source>
        <translation>Le tableau {} du générateur contient {} ; les variances ne sont pas inférieures à 0.</translation>
    </message>
    <message>
        <source>The generator&apos;s shape of {} dimensions, coarsest scale {}, {} channels of noise, steps of {} and {} channels is none that can be evaluated.</source>
        <translation>La forme du générateur, de {} dimensions, d’échelle la plus grossière {}, de {} canaux de bruit, de pas de {} et de {} canaux, ne peut pas être évaluée.</translation>
    </message>
    <message>
        <source>The hole of {:.0f} px is larger than the {:.0f} px of the picture that are left to fill it from; mark a smaller one, or add another exemplar.</source>
        <translation>Le trou de {:.0f} px est plus grand que les {:.0f} px de l’image qui restent pour le remplir ; marquez-en un plus petit ou ajoutez un autre échantillon.</translation>
    </message>
    <message>
        <source>The last layer that is compared, or all that there are; a smaller number leaves large structures free and is faster.</source>
        <translation>La dernière couche comparée, ou toutes celles qu&apos;il y a ; un nombre plus petit laisse libres les grandes structures et va plus vite.</translation>
    </message>
    <message>
        <source>The maps of the material have {} × {} and {} × {} px, so that they do not lie on one another; choose maps of one size.</source>
        <translation>Les cartes du matériau font {} × {} et {} × {} px et ne se superposent donc pas ; choisissez des cartes d’une même taille.</translation>
    </message>
    <message>
        <source>The mesh has no face, so that there is nothing to show a material on; choose another one.</source>
        <translation>Le maillage n’a aucune face où montrer un matériau ; choisissez-en un autre.</translation>
    </message>
    <message>
        <source>The network has no layer for the tap {}.</source>
        <translation>Le réseau n&apos;a pas de couche pour la prise {}.</translation>
    </message>
    <message>
        <source>The network whose feature maps are compared: the file that is given, else Texloom&apos;s own; maps beside colours need one that sees them: learned from the exemplar, random or wavelets.</source>
        <translation>Le réseau dont les cartes de caractéristiques sont comparées : le fichier donné, sinon celui de Texloom ; des cartes à côté des couleurs en demandent un qui les voit : appris de l&apos;échantillon, aléatoire ou ondelettes.</translation>
    </message>
    <message>
        <source>The solid in space, without end; the picture is its slice at z = 0.</source>
        <translation>Le solide dans l’espace, sans fin ; l’image en est la coupe en z = 0.</translation>
    </message>
    <message>
        <source>The solid, which repeats after its side along every axis.</source>
        <translation>Le solide, qui se répète après son côté le long de chaque axe.</translation>
    </message>
    <message>
        <source>The weights of {} do not fit {} channels and a square of odd side, or have no bias.</source>
        <translation>Les poids de {} ne conviennent pas à {} canaux et à un carré de côté impair, ou n&apos;ont pas de biais.</translation>
    </message>
    <message>
        <source>The weights of {} hold values that are not numbers.</source>
        <translation>Les poids de {} contiennent des valeurs qui ne sont pas des nombres.</translation>
    </message>
    <message>
        <source>The weights of {} lie beyond the end of the file, which holds {} numbers: it is cut short or of another network.</source>
        <translation>Les poids de {} sont au-delà de la fin du fichier, qui contient {} nombres : il est tronqué ou d&apos;un autre réseau.</translation>
    </message>
    <message>
        <source>There is no light in this panorama; choose another picture.</source>
        <translation>Il n’y a pas de lumière dans ce panorama ; choisissez une autre image.</translation>
    </message>
    <message>
        <source>Third</source>
        <translation>Troisième</translation>
    </message>
    <message>
        <source>Total variation</source>
        <translation>Variation totale</translation>
    </message>
    <message>
        <source>Training</source>
        <translation>Entraînement</translation>
    </message>
    <message>
        <source>Trains a small network on single slices, which then makes any part of an endless solid at once. For grain and blobs that look alike in all directions, and, with one axis free, for what runs along it.</source>
        <translation>Entraîne un petit réseau sur des coupes isolées, qui fait ensuite aussitôt n’importe quelle partie d’un solide sans fin. Pour le grain et les taches semblables dans toutes les directions et, avec un axe libre, pour ce qui le longe.</translation>
    </message>
    <message>
        <source>Turn square to x</source>
        <translation>Rotation perpendiculaire à x</translation>
    </message>
    <message>
        <source>Turn square to y</source>
        <translation>Rotation perpendiculaire à y</translation>
    </message>
    <message>
        <source>Turn square to z</source>
        <translation>Rotation perpendiculaire à z</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volume</translation>
    </message>
    <message>
        <source>Voxels along each axis, after which the solid repeats: twice as many take eight times as long.</source>
        <translation>Voxels le long de chaque axe, après lesquels le solide se répète : deux fois plus prennent huit fois plus de temps.</translation>
    </message>
    <message>
        <source>Wavelets</source>
        <translation>Ondelettes</translation>
    </message>
    <message>
        <source>Weight of patches</source>
        <translation>Poids des morceaux</translation>
    </message>
    <message>
        <source>Weight of the descriptor</source>
        <translation>Poids du descripteur</translation>
    </message>
    <message>
        <source>Weight square to x</source>
        <translation>Poids perpendiculaire à x</translation>
    </message>
    <message>
        <source>Weight square to y</source>
        <translation>Poids perpendiculaire à y</translation>
    </message>
    <message>
        <source>Weight square to z</source>
        <translation>Poids perpendiculaire à z</translation>
    </message>
    <message>
        <source>What is compared of the feature maps: their moments once each has the exemplar&apos;s mean and deviation, their Gram matrices as published, or these relative to the exemplar&apos;s.</source>
        <translation>Ce qui est comparé des cartes de caractéristiques : leurs moments une fois chacune rapportée à la moyenne et à l&apos;écart de l&apos;échantillon, leurs matrices de Gram comme publié, ou celles-ci relativement à celles de l&apos;échantillon.</translation>
    </message>
    <message>
        <source>What slices look like: one image for all directions, or one each for those square to z, y and x.</source>
        <translation>L’aspect des coupes : une image pour toutes les directions, ou une pour chacune de celles perpendiculaires à z, y et x.</translation>
    </message>
    <message>
        <source>What slices square to this axis look like. Own is the first exemplar for z, the second for y and the third for x, or the first where there are fewer; of a free axis nothing is wanted, as along the grain of wood.</source>
        <translation>L’aspect des coupes perpendiculaires à cet axe. Le sien est le premier échantillon pour z, le deuxième pour y et le troisième pour x, ou le premier s’il y en a moins ; d’un axe libre rien n’est demandé, comme le long du fil du bois.</translation>
    </message>
    <message>
        <source>What was learned, under half a megabyte: `texloom-cli sample` makes boxes, slices and coloured meshes of it.</source>
        <translation>Ce qui a été appris, moins d’un demi-mégaoctet : `texloom-cli sample` en fait des boîtes, des coupes et des maillages colorés.</translation>
    </message>
    <message>
        <source>Where a hole is filled, moves the borders between what is copied to where they are seen least, so that few large pieces take the place of many small ones.</source>
        <translation>Là où un trou est rempli, déplace les limites entre ce qui est copié là où elles se voient le moins, de sorte que peu de grands morceaux remplacent beaucoup de petits.</translation>
    </message>
    <message>
        <source>Where a hole is filled, takes the brightness and colour of what is copied from what is around it, so that no border is seen where the light changes; what is known stays as it is. Off: every pixel is a copy.</source>
        <translation>Là où un trou est rempli, la luminosité et la couleur de ce qui est copié suivent ce qui l’entoure, de sorte qu’aucun bord ne se voit là où la lumière change ; ce qui est connu reste tel quel. Désactivé : chaque pixel est une copie.</translation>
    </message>
    <message>
        <source>Writing a turn</source>
        <translation>Écriture d’un tour</translation>
    </message>
    <message>
        <source>a chain of its network does not end in a tap</source>
        <translation>une chaîne de son réseau ne finit pas par une prise</translation>
    </message>
    <message>
        <source>a channel of the file, counted from 0</source>
        <translation>un canal du fichier, compté à partir de 0</translation>
    </message>
    <message>
        <source>a length from 1 to {}</source>
        <translation>une longueur de 1 à {}</translation>
    </message>
    <message>
        <source>its head lacks “{}”</source>
        <translation>son en-tête n&apos;a pas « {} »</translation>
    </message>
    <message>
        <source>its network has more than {} steps</source>
        <translation>son réseau a plus de {} étapes</translation>
    </message>
    <message>
        <source>the weights of its layer {} do not fit {} channels and a square of odd side</source>
        <translation>les poids de sa couche {} ne conviennent pas à {} canaux et à un carré de côté impair</translation>
    </message>
    <message>
        <source>there are no weights for its layer {}</source>
        <translation>il n&apos;y a pas de poids pour sa couche {}</translation>
    </message>
    <message>
        <source>{} cannot be read.</source>
        <translation>{} ne peut pas être lu.</translation>
    </message>
    <message>
        <source>{} holds more than {} bytes; unpack it first.</source>
        <translation>{} contient plus de {} octets ; décompressez-la d’abord.</translation>
    </message>
    <message>
        <source>{} holds no picture that can be opened.</source>
        <translation>{} ne contient aucune image qui puisse être ouverte.</translation>
    </message>
    <message>
        <source>{} holds {} files, more than {}; unpack it first.</source>
        <translation>{} contient {} fichiers, plus de {} ; décompressez-la d’abord.</translation>
    </message>
    <message>
        <source>{} holds {} pictures; open those that you want.</source>
        <translation>{} contient {} images ; ouvrez celles que vous voulez.</translation>
    </message>
    <message>
        <source>{} in {} is packed in a way that is not read; unpack the archive first.</source>
        <translation>{} dans {} est comprimé d’une façon qui n’est pas lue ; décompressez d’abord l’archive.</translation>
    </message>
    <message>
        <source>{} is a ZIP64 archive, which is not read; unpack it first.</source>
        <translation>{} est une archive ZIP64, qui n’est pas lue ; décompressez-la d’abord.</translation>
    </message>
    <message>
        <source>{} is broken or no ZIP archive.</source>
        <translation>{} est endommagé ou n’est pas une archive ZIP.</translation>
    </message>
    <message>
        <source>{} is grey and is taken as coloured, as the others are.</source>
        <translation>{} est en gris et est pris comme étant en couleur, comme les autres.</translation>
    </message>
    <message>
        <source>{} is no .json: name the one that lies beside the .bin with the weights.</source>
        <translation>{} n&apos;est pas un .json : nommez celui qui se trouve à côté du .bin des poids.</translation>
    </message>
    <message>
        <source>{} already exists; choose a folder without pictures of an earlier turn.</source>
        <translation>{} existe déjà ; choisissez un dossier sans images d’un tour précédent.</translation>
    </message>
    <message>
        <source>{} names no convolution conv1_1: it is no network of VGG&apos;s kind.</source>
        <translation>{} ne nomme aucune convolution conv1_1 : ce n&apos;est pas un réseau du genre VGG.</translation>
    </message>
    <message>
        <source>{}: meshes with colours are written as .ply, .obj or .glb.</source>
        <translation>{} : les maillages colorés sont écrits en .ply, .obj ou .glb.</translation>
    </message>
    <message>
        <source>{}: {} vertices want three numbers each, and there are {}.</source>
        <translation>{} : {} sommets demandent trois nombres chacun, et il y en a {}.</translation>
    </message>
    <message>
        <source>“pooling” of its head is neither average nor maximum</source>
        <translation>« pooling » de son en-tête n&apos;est ni average ni maximum</translation>
    </message>
    <message>
        <source>“{}” in its network means nothing there</source>
        <translation>« {} » ne signifie rien à cet endroit de son réseau</translation>
    </message>
    <message>
        <source>“{}” of its head is no number from {} to {}</source>
        <translation>« {} » de son en-tête n&apos;est pas un nombre de {} à {}</translation>
    </message>
    <message>
        <source>Distributes the patches of all slices as the exemplar&apos;s are, which is sharpest; or matches histograms of pyramids, quick, for grain without shapes; or copies neighbourhoods (Kopf), soft where directions disagree; or makes one voxel after another (Wei).</source>
        <translation>Distribue les morceaux de toutes les coupes comme ceux de l’échantillon, ce qui est le plus net ; ou égalise des histogrammes de pyramides, rapide, pour du grain sans formes ; ou copie des voisinages (Kopf), doux là où les directions ne s’accordent pas ; ou fait un voxel après l’autre (Wei).</translation>
    </message>
    <message>
        <source>Gatys, Ecker and Bethge: plain Gram matrices on one scale and one level from noise, 2,000 iterations at most; give it their VGG-19 as its descriptor.</source>
        <translation>Gatys, Ecker et Bethge : matrices de Gram simples à une échelle et un niveau depuis un bruit, 2 000 itérations au plus ; donnez-lui leur VGG-19 pour descripteur.</translation>
    </message>
    <message>
        <source>Gram matrices of several networks</source>
        <translation>Matrices de Gram de plusieurs réseaux</translation>
    </message>
    <message>
        <source>Gram matrices, as published</source>
        <translation>Matrices de Gram, comme publié</translation>
    </message>
    <message>
        <source>How many sizes of the picture, each half the one before, the network sees at once: more hold larger structures together; 0 leaves it to the descriptor.</source>
        <translation>Combien de tailles de l&apos;image, chacune moitié de la précédente, le réseau voit à la fois : davantage tient ensemble de plus grandes structures ; 0 s&apos;en remet au descripteur.</translation>
    </message>
    <message>
        <source>Largest of four instead of the mean</source>
        <translation>La plus grande de quatre au lieu de la moyenne</translation>
    </message>
    <message>
        <source>The same texture by four descriptors, and by one with the other kind of pooling, as figure 4.8 of Gutierrez&apos; thesis compares them.</source>
        <translation>La même texture par quatre descripteurs, et par l&apos;un d&apos;eux avec l&apos;autre mise en commun, comme les compare la figure 4.8 de la thèse de Gutierrez.</translation>
    </message>
    <message>
        <source>Autocorrelations apart</source>
        <translation>Écart des autocorrélations</translation>
    </message>
    <message>
        <source>Contrast kept</source>
        <translation>Contraste conservé</translation>
    </message>
    <message>
        <source>From the most used part of the exemplar, %</source>
        <translation>Issu de la partie la plus utilisée de l’échantillon, %</translation>
    </message>
    <message>
        <source>How far flat patches are kept from winning in whole outputs where nothing fits well, and parts of one flat colour from growing beyond their share: 1 holds the exemplar&apos;s contrast; 0 compares as published, and outputs may fade.</source>
        <translation>À quel point, dans les sorties entières, les patchs plats sont empêchés de l’emporter là où rien ne convient bien, et les parties unies de croître au-delà de leur part : 1 garde le contraste de l’échantillon ; 0 compare comme publié, et les sorties peuvent pâlir.</translation>
    </message>
    <message>
        <source>How much pieces that were copied near by are avoided in whole outputs: larger repeats itself less, but joins worse; 0 takes whatever fits best, as published.</source>
        <translation>À quel point, dans les sorties entières, les morceaux déjà copiés à proximité sont évités : plus grand se répète moins, mais raccorde moins bien ; 0 prend ce qui convient le mieux, comme publié.</translation>
    </message>
    <message>
        <source>Jump where pieces meet</source>
        <translation>Saut là où les morceaux se rejoignent</translation>
    </message>
    <message>
        <source>Lattice kept</source>
        <translation>Réseau conservé</translation>
    </message>
    <message>
        <source>Layout</source>
        <translation>Disposition</translation>
    </message>
    <message>
        <source>Quilted</source>
        <translation>Assemblée par quilting</translation>
    </message>
    <message>
        <source>The settings of Raad &amp; Galerne, IPOL 2017: patches of 40 px, a quarter of overlap, a tolerance of 0.1, contrast not balanced, and pieces used again wherever they fit.</source>
        <translation>Les réglages de Raad &amp; Galerne, IPOL 2017 : patchs de 40 px, un quart de recouvrement, une tolérance de 0,1, contraste non équilibré, et morceaux réutilisés partout où ils conviennent.</translation>
    </message>
    <message>
        <source>The vectors of {} no longer agreed with {} (slopes alike by {:.2f}, in the exemplar by {:.2f}), so they were derived from the heights.</source>
        <translation>Les vecteurs de {} ne concordaient plus avec {} (pentes semblables à {:.2f}, dans l’échantillon à {:.2f}) ; ils ont donc été déduits des hauteurs.</translation>
    </message>
    <message>
        <source>Variety</source>
        <translation>Variété</translation>
    </message>
    <message>
        <source>What an output that is larger than the exemplar, or wraps, is a variant of: a quilt of it, or its mirror images, which show as a kaleidoscope. An initial image takes their place.</source>
        <translation>Ce dont une sortie plus grande que l’échantillon, ou qui se raccorde, est une variante : un quilt de celui-ci, ou ses images en miroir, qui se voient comme un kaléidoscope. Une image de départ prend leur place.</translation>
    </message>
    <message>
        <source>{} does not cover the output, so its patches were first laid out by image quilting; give an initial image for a layout of your own.</source>
        <translation>{} ne couvre pas la sortie ; ses patchs ont donc d’abord été disposés par quilting d’images ; donnez une image de départ pour une disposition de votre choix.</translation>
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
        <translation>Une échelle de {} voxels par unité du maillage n’en est pas une ; elle doit être supérieure à 0.</translation>
    </message>
    <message>
        <source>A trained generator to make the texture with, or to train further.</source>
        <translation>Un générateur entraîné qui fait la texture, ou à entraîner davantage.</translation>
    </message>
    <message>
        <source>An exemplar with a longer one is scaled down to this, and features with it: larger keeps more detail and takes much longer to learn.</source>
        <translation>Un échantillon qui en a un plus long est réduit à cette taille, et ses motifs avec lui : plus grand garde plus de détails et s’apprend bien plus lentement.</translation>
    </message>
    <message>
        <source>Batch</source>
        <translation>Lot</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>Les deux</translation>
    </message>
    <message>
        <source>Colouring a mesh</source>
        <translation>Coloration d’un maillage</translation>
    </message>
    <message>
        <source>Compare by</source>
        <translation>Comparer par</translation>
    </message>
    <message>
        <source>Decay</source>
        <translation>Décroissance</translation>
    </message>
    <message>
        <source>Decay every</source>
        <translation>Décroissance tous les</translation>
    </message>
    <message>
        <source>Even gradients</source>
        <translation>Équilibrer les gradients</translation>
    </message>
    <message>
        <source>Feature maps that each scale adds, 8 as published: more hold more of the texture, and take longer by their square.</source>
        <translation>Cartes de caractéristiques que chaque échelle ajoute, 8 dans la publication : davantage retiennent plus de la texture et prennent un temps qui croît comme leur carré.</translation>
    </message>
    <message>
        <source>Figure 4.3 of Gutierrez&apos; thesis: the same noise through the generator after more and more iterations. First colours, then soft shapes, then edges and detail; the curve of the loss is under Figures.</source>
        <translation>Figure 4.3 de la thèse de Gutierrez : le même bruit à travers le générateur après de plus en plus d’itérations. D’abord les couleurs, puis des formes douces, puis les contours et les détails ; la courbe de la perte est sous Mesures.</translation>
    </message>
    <message>
        <source>Figures 4.4 and 4.5 of Gutierrez&apos; thesis: the rate falls by 0.8 now and then, in batches of one or four samples. See the curve of the loss under Figures.</source>
        <translation>Figures 4.4 et 4.5 de la thèse de Gutierrez : le taux baisse de temps en temps d’un facteur 0,8, par lots d’un ou de quatre échantillons. Voir la courbe de la perte sous Mesures.</translation>
    </message>
    <message>
        <source>Figures 4.6 to 4.9 of Gutierrez&apos; thesis in small: the exemplar learned at three sizes, the descriptor&apos;s pooling by mean and by maximum, and gradients as they are or evened out over its taps.</source>
        <translation>Figures 4.6 à 4.9 de la thèse de Gutierrez en petit : l’échantillon appris en trois tailles, le mise en commun du descripteur par moyenne et par maximum, et les gradients tels quels ou équilibrés entre ses prises.</translation>
    </message>
    <message>
        <source>Gives the gradient at each tap of the descriptor the same norm, so that all have their say, whatever their loss.</source>
        <translation>Donne au gradient de chaque prise du descripteur la même norme, pour que toutes comptent, quelle que soit leur perte.</translation>
    </message>
    <message>
        <source>Goes on training the generator that is given; else it only makes the texture, at once.</source>
        <translation>Continue d’entraîner le générateur donné ; sinon il fait seulement la texture, aussitôt.</translation>
    </message>
    <message>
        <source>Gradients</source>
        <translation>Gradients</translation>
    </message>
    <message>
        <source>Halvings</source>
        <translation>Divisions par deux</translation>
    </message>
    <message>
        <source>How far each step goes at the beginning. Too large, and the loss jumps; too small, and it falls slowly.</source>
        <translation>Longueur de chaque pas au début. Trop grand, la perte fait des sauts ; trop petit, elle baisse lentement.</translation>
    </message>
    <message>
        <source>How often the generator&apos;s noise is halved in size: each scale more lets features be twice as large.</source>
        <translation>Combien de fois la taille du bruit du générateur est divisée par deux : chaque échelle de plus permet des motifs deux fois plus grands.</translation>
    </message>
    <message>
        <source>It has rows {:.0f} px apart, so methods that keep rows come first.</source>
        <translation>Elle a des rangées distantes de {:.0f} px ; les méthodes qui gardent les rangées viennent donc en premier.</translation>
    </message>
    <message>
        <source>It repeats itself every {:.0f} px, so methods that follow a lattice come first.</source>
        <translation>Elle se répète tous les {:.0f} px ; les méthodes qui suivent un réseau viennent donc en premier.</translation>
    </message>
    <message>
        <source>Iterations after which the learning rate falls; 0 for a tenth of them all.</source>
        <translation>Itérations après lesquelles le taux d’apprentissage baisse ; 0 pour un dixième du total.</translation>
    </message>
    <message>
        <source>Its shapes reach over {:.0f} px of {} × {} px, so methods that keep large pieces come first.</source>
        <translation>Ses formes s&apos;étendent sur {:.0f} px de {} × {} px ; les méthodes qui gardent de grands morceaux viennent donc en premier.</translation>
    </message>
    <message>
        <source>Making the texture</source>
        <translation>Création de la texture</translation>
    </message>
    <message>
        <source>Noise channels</source>
        <translation>Canaux de bruit</translation>
    </message>
    <message>
        <source>Of the random numbers that each scale begins with.</source>
        <translation>Des nombres aléatoires par lesquels commence chaque échelle.</translation>
    </message>
    <message>
        <source>Of the textures that are made and compared in training: larger ones say more of large features, and take longer.</source>
        <translation>Des textures faites et comparées pendant l’entraînement : plus grandes, elles en disent plus sur les grands motifs et prennent plus de temps.</translation>
    </message>
    <message>
        <source>Padding</source>
        <translation>Remplissage des bords</translation>
    </message>
    <message>
        <source>Samples in one iteration: more make each step surer and longer.</source>
        <translation>Échantillons par itération : davantage rendent chaque pas plus sûr et plus long.</translation>
    </message>
    <message>
        <source>Samples of {} px are too small for the network, which needs {} px a side.</source>
        <translation>Des échantillons de {} px sont trop petits pour le réseau, qui demande {} px de côté.</translation>
    </message>
    <message>
        <source>Side of samples</source>
        <translation>Côté des échantillons</translation>
    </message>
    <message>
        <source>Texture network</source>
        <translation>Réseau de texture</translation>
    </message>
    <message>
        <source>Texture network, as published</source>
        <translation>Réseau de texture, comme publié</translation>
    </message>
    <message>
        <source>Texture network: learning rate and batch</source>
        <translation>Réseau de texture : taux d’apprentissage et lot</translation>
    </message>
    <message>
        <source>Texture network: resolution, pooling, gradients</source>
        <translation>Réseau de texture : résolution, mise en commun, gradients</translation>
    </message>
    <message>
        <source>Texture network: what training does</source>
        <translation>Réseau de texture : ce que fait l’entraînement</translation>
    </message>
    <message>
        <source>The box of {} has {} voxels, and one file holds up to {}; write several boxes, which fit together.</source>
        <translation>La boîte de {} a {} voxels, et un fichier en contient jusqu’à {} ; écrivez plusieurs boîtes, qui se raccordent.</translation>
    </message>
    <message>
        <source>The exemplar has {} channels with its maps; a generator makes at most {}.</source>
        <translation>L’échantillon a {} canaux avec ses cartes ; un générateur en fait au plus {}.</translation>
    </message>
    <message>
        <source>The mesh has no face that could be coloured; choose another one.</source>
        <translation>Le maillage n’a aucune face à colorer ; choisissez-en un autre.</translation>
    </message>
    <message>
        <source>There is neither an exemplar to learn from nor a trained generator to make a texture with.</source>
        <translation>Il n’y a ni échantillon dont apprendre, ni générateur entraîné pour faire une texture.</translation>
    </message>
    <message>
        <source>There is no generator to train further: give one, or train a new one.</source>
        <translation>Il n’y a pas de générateur à entraîner davantage : en donner un, ou entraîner de nouveau.</translation>
    </message>
    <message>
        <source>Train further</source>
        <translation>Entraîner davantage</translation>
    </message>
    <message>
        <source>Trains a small network until what it makes of noise looks like the exemplar; trained, it makes textures of any size at once. For patterns without strict order.</source>
        <translation>Entraîne un petit réseau jusqu’à ce que ce qu’il fait du bruit ressemble à l’échantillon ; entraîné, il fait aussitôt des textures de toute taille. Pour des motifs sans ordre strict.</translation>
    </message>
    <message>
        <source>Ulyanov et al. as Gutierrez trains them: plain Gram matrices of 256 px, circular padding, batches of four and 5,000 iterations, with the rate falling by 0.8; give it their VGG-19 as its descriptor. Takes hours.</source>
        <translation>Ulyanov et al. comme Gutierrez les entraîne : de simples matrices de Gram de 256 px, remplissage circulaire, lots de quatre et 5 000 itérations, le taux baissant d’un facteur 0,8 ; donner leur VGG-19 comme descripteur. Prend des heures.</translation>
    </message>
    <message>
        <source>What of samples and exemplar is compared: the feature maps of a descriptor, the distribution of small patches, which makes edges sharper, or both.</source>
        <translation>Ce qui est comparé des échantillons et de l’échantillon : les cartes de caractéristiques d’un descripteur, la distribution de petits morceaux, qui rend les contours plus nets, ou les deux.</translation>
    </message>
    <message>
        <source>What samples find beyond their edges in training: more of an endless texture, or their other end, as published. Either generator makes any part of any size, and wraps.</source>
        <translation>Ce que les échantillons trouvent au-delà de leurs bords pendant l’entraînement : la suite d’une texture sans fin, ou leur autre bout, comme publié. L’un et l’autre générateur fait toute partie de toute taille, et se raccorde.</translation>
    </message>
    <message>
        <source>What the learning rate is multiplied by each time that it falls.</source>
        <translation>Ce par quoi le taux d’apprentissage est multiplié chaque fois qu’il baisse.</translation>
    </message>
    <message>
        <source>What was learned, under half a megabyte: given to this method, it makes any size and any part of the texture without training.</source>
        <translation>Ce qui a été appris, moins d’un demi-mégaoctet : donné à cette méthode, cela fait toute taille et toute partie de la texture sans entraînement.</translation>
    </message>
    <message>
        <source>Writing a box</source>
        <translation>Écriture d’une boîte</translation>
    </message>
    <message>
        <source>Writing a slice</source>
        <translation>Écriture d’une coupe</translation>
    </message>
    <message>
        <source>It is alike over about {:.0f} px and does not repeat, so methods that join copied pieces come first.</source>
        <translation>Elle est semblable sur {:.0f} px environ et ne se répète pas ; les méthodes qui assemblent des morceaux copiés viennent donc en premier.</translation>
    </message>
    <message>
        <source>It is grain, alike over no more than {:.0f} px, so methods that keep statistics come first.</source>
        <translation>C&apos;est du grain, semblable sur {:.0f} px au plus ; les méthodes qui gardent les statistiques viennent donc en premier.</translation>
    </message>
    <message>
        <source>A region cloned without a seam</source>
        <translation>Une région clonée sans couture</translation>
    </message>
    <message>
        <source>Figures 5.36 to 5.41 of Raad&apos;s thesis on free exemplars: strips of rock, metal and wood in a new order, then squares of rock and metal, squares of two exemplars together, and a chaos mosaic of ballast, each three times.</source>
        <translation>Figures 5.36 à 5.41 de la thèse de Raad sur des échantillons libres : bandes de roche, de métal et de bois dans un nouvel ordre, puis carrés de roche et de métal, carrés de deux échantillons ensemble, et une mosaïque chaotique de ballast, trois fois chacun.</translation>
    </message>
    <message>
        <source>Figures 5.43 and 5.44 of Raad&apos;s thesis on free exemplars: of two images, each pixel gets the stronger gradient. The first gives its colours, the second its marks; with free borders, as printed, shades may drift.</source>
        <translation>Figures 5.43 et 5.44 de la thèse de Raad sur des échantillons libres : de deux images, chaque pixel reçoit le gradient le plus fort. La première donne ses couleurs, la seconde ses marques ; avec des bords libres, comme imprimé, les teintes peuvent dériver.</translation>
    </message>
    <message>
        <source>Fourier mask: how much the waves count</source>
        <translation>Masque de Fourier : le poids des ondes</translation>
    </message>
    <message>
        <source>Graph cuts: three ways to place a patch</source>
        <translation>Coupes de graphe : trois façons de placer un morceau</translation>
    </message>
    <message>
        <source>Kwatra and others 2003: the exemplar pasted at random, where all of it fits, or where a square of it does; then the worst seams mended more and more often.</source>
        <translation>Kwatra et autres 2003 : l’échantillon collé au hasard, là où il convient en entier, ou là où l’un de ses carrés convient ; puis les pires coutures réparées de plus en plus souvent.</translation>
    </message>
    <message>
        <source>Liu, Tsin and Lin 2005 stitch whole tiles along the lattice, beside blocks at random; Liu 2004 draws every tile&apos;s colours anew from the principal components of all of them.</source>
        <translation>Liu, Tsin et Lin 2005 cousent des tuiles entières le long du réseau, à côté de blocs au hasard ; Liu 2004 retire les couleurs de chaque tuile des composantes principales de toutes.</translation>
    </message>
    <message>
        <source>Mixed by gradients: a plain material and one with marks</source>
        <translation>Mélange par gradients : une matière sobre et une marquée</translation>
    </message>
    <message>
        <source>Nicoll and others 2005: patches that follow the exemplar&apos;s waves not at all, as much as their overlaps, and more. Rows and columns keep their order over the whole output.</source>
        <translation>Nicoll et autres 2005 : des morceaux qui ne suivent pas du tout les ondes de l’échantillon, autant que leurs recouvrements, puis davantage. Rangées et colonnes gardent leur ordre sur toute la sortie.</translation>
    </message>
    <message>
        <source>The middle of one image in another: with its own structure, with the stronger structure of both, and pasted as it is, which shows what the equation does.</source>
        <translation>Le milieu d’une image dans une autre : avec sa propre structure, avec la plus forte des deux, et collé tel quel, ce qui montre ce que fait l’équation.</translation>
    </message>
    <message>
        <source>Tiles of a regular texture: whole, and varied in colour</source>
        <translation>Tuiles d’une texture régulière : entières, et de couleurs variées</translation>
    </message>
    <message>
        <source>Wang tiles: more colours, more tiles</source>
        <translation>Tuiles de Wang : plus de couleurs, plus de tuiles</translation>
    </message>
    <message>
        <source>{} edits one image and joins no two; leave it to the edits of an exemplar.</source>
        <translation>{} modifie une image et n’en joint pas deux ; laissez-le aux retouches d’un échantillon.</translation>
    </message>
    <message>
        <source>The checkpoint was written by Texloom {}; this is {}, which may go on otherwise. Start the run again, or use that version.</source>
        <translation>Le point de reprise vient de Texloom {} ; celui-ci est {}, qui peut poursuivre autrement. Recommencez le calcul, ou prenez cette version-là.</translation>
    </message>
    <message>
        <source>Training ended after {} of {} iterations, since the next gave values that are not numbers; the generator is that of the last good step. A smaller learning rate may go further.</source>
        <translation>L’entraînement s’est terminé après {} itérations sur {}, car la suivante a donné des valeurs qui ne sont pas des nombres ; le générateur est celui du dernier bon pas. Un taux d’apprentissage plus petit ira peut-être plus loin.</translation>
    </message>
    <message>
        <source>Aggregation, fig. 3.14</source>
        <translation>Agrégation, fig. 3.14</translation>
    </message>
    <message>
        <source>Blended band, fig. 5.12</source>
        <translation>Bande fondue, fig. 5.12</translation>
    </message>
    <message>
        <source>Constrained sampling</source>
        <translation>Tirage sous contrainte</translation>
    </message>
    <message>
        <source>Figure 4.19 of Gutierrez&apos; thesis: the same exemplar wanted square to one axis, to two and to three. What no solid can have from all sides, such as bricks, gets worse with each.</source>
        <translation>Figure 4.19 de la thèse de Gutierrez : le même échantillon demandé perpendiculairement à un axe, à deux, à trois. Ce qu’aucun solide ne peut montrer de tous les côtés, comme des briques, se dégrade à chaque fois.</translation>
    </message>
    <message>
        <source>Figure 4.22 of Gutierrez&apos; thesis: one exemplar square to z and another square to the other axes, with their own colours and with those of the first given to both, without which slices cannot agree.</source>
        <translation>Figure 4.22 de la thèse de Gutierrez : un échantillon perpendiculaire à z et un autre aux deux autres axes, avec leurs propres couleurs, puis avec celles du premier pour les deux, sans quoi les coupes ne peuvent s’accorder.</translation>
    </message>
    <message>
        <source>Figure 5.23 of Raad&apos;s thesis: patches of a local Gaussian model alone (LG), then quilted over with pieces of the exemplar (LG+EF), or given the exemplar&apos;s statistics (LG+PS), which brings the grain back.</source>
        <translation>Figure 5.23 de la thèse de Raad : les patchs d’un modèle gaussien local seuls (LG), puis recouverts de morceaux de l’échantillon (LG+EF), ou ramenés à ses statistiques (LG+PS), ce qui rend le grain.</translation>
    </message>
    <message>
        <source>Figures 3.8 and 3.9 of Raad&apos;s thesis: patches of 10, 20 and 40 px from 10, 50 and 150 neighbours at two scales, then one, two and three scales. More neighbours smooth; one scale alone loses the layout.</source>
        <translation>Figures 3.8 et 3.9 de la thèse de Raad : patchs de 10, 20 et 40 px tirés de 10, 50 et 150 voisins à deux échelles, puis une, deux et trois échelles. Plus de voisins lissent ; une seule échelle perd la disposition.</translation>
    </message>
    <message>
        <source>Figures 3.8 to 3.18 of Gutierrez&apos; thesis: where patches are taken, how they are put together, how strictly each is used once, how exactly the assignment is solved, and four other methods beside it. The energy of each run is in its curves.</source>
        <translation>Figures 3.8 à 3.18 de la thèse de Gutierrez : où les patchs sont pris, comment ils sont assemblés, avec quelle rigueur chacun sert une fois, avec quelle exactitude l’affectation est résolue, et quatre autres méthodes à côté. Les courbes de chaque calcul montrent son énergie.</translation>
    </message>
    <message>
        <source>Figures 5.2 to 5.13 of López Recas&apos; thesis: the best tile repeated, constrained random sampling and quilting on near-regular exemplars; narrow and wide blended bands; and irregular exemplars, sampled without a lattice.</source>
        <translation>Figures 5.2 à 5.13 du mémoire de López Recas : le meilleur carreau répété, le tirage sous contrainte et le quilting sur des échantillons presque réguliers ; bandes fondues étroites et larges ; et des échantillons irréguliers, tirés sans réseau.</translation>
    </message>
    <message>
        <source>Figures 9 to 11 of Raad &amp; Galerne (IPOL 2017): each of the three settings is varied while the others keep their published values. Small patches lose the structure, large ones copy verbatim; the position map of each result shows how much.</source>
        <translation>Figures 9 à 11 de Raad &amp; Galerne (IPOL 2017) : chacun des trois réglages varie tandis que les autres gardent leurs valeurs publiées. De petits patchs perdent la structure, de grands copient mot à mot ; la carte de positions de chaque résultat montre combien.</translation>
    </message>
    <message>
        <source>Grid, fig. 3.12</source>
        <translation>Grille, fig. 3.12</translation>
    </message>
    <message>
        <source>Irregular, fig. 5.13</source>
        <translation>Irrégulier, fig. 5.13</translation>
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
        <translation>Localement gaussien, et ce qui le suit</translation>
    </message>
    <message>
        <source>Multiscale Gaussian: patch, neighbours, scales</source>
        <translation>Gaussien multi-échelle : patch, voisins, échelles</translation>
    </message>
    <message>
        <source>Near-optimal, fig. 3.18</source>
        <translation>Presque optimal, fig. 3.18</translation>
    </message>
    <message>
        <source>Near-regular textures beside tiles and quilting</source>
        <translation>Textures presque régulières à côté des carreaux et du quilting</translation>
    </message>
    <message>
        <source>One direction</source>
        <translation>Une direction</translation>
    </message>
    <message>
        <source>Overlap, fig. 10</source>
        <translation>Recouvrement, fig. 10</translation>
    </message>
    <message>
        <source>Patch and neighbours, fig. 3.8</source>
        <translation>Patch et voisins, fig. 3.8</translation>
    </message>
    <message>
        <source>Patch assignment: grids, aggregation, relaxation, tolerance</source>
        <translation>Affectation de patchs : grilles, agrégation, relâchement, tolérance</translation>
    </message>
    <message>
        <source>Patch size, fig. 9</source>
        <translation>Taille du patch, fig. 9</translation>
    </message>
    <message>
        <source>PatchMatch, fig. 3.13</source>
        <translation>PatchMatch, fig. 3.13</translation>
    </message>
    <message>
        <source>Portilla–Simoncelli, fig. 3.13</source>
        <translation>Portilla–Simoncelli, fig. 3.13</translation>
    </message>
    <message>
        <source>Quilting</source>
        <translation>Quilting</translation>
    </message>
    <message>
        <source>Quilting: patch, overlap, tolerance</source>
        <translation>Quilting : patch, recouvrement, tolérance</translation>
    </message>
    <message>
        <source>Relaxed, fig. 3.16</source>
        <translation>Relâché, fig. 3.16</translation>
    </message>
    <message>
        <source>Scales, fig. 3.9</source>
        <translation>Échelles, fig. 3.9</translation>
    </message>
    <message>
        <source>Solids: one, two and three directions</source>
        <translation>Solides : une, deux et trois directions</translation>
    </message>
    <message>
        <source>Solids: two exemplars</source>
        <translation>Solides : deux échantillons</translation>
    </message>
    <message>
        <source>Solids: which way the exemplar is turned</source>
        <translation>Solides : comment l’échantillon est tourné</translation>
    </message>
    <message>
        <source>Sparse, fig. 3.13</source>
        <translation>Parcimonieux, fig. 3.13</translation>
    </message>
    <message>
        <source>Texture optimization, fig. 3.13</source>
        <translation>Optimisation de texture, fig. 3.13</translation>
    </message>
    <message>
        <source>The best tile, repeated</source>
        <translation>Le meilleur carreau, répété</translation>
    </message>
    <message>
        <source>Three directions</source>
        <translation>Trois directions</translation>
    </message>
    <message>
        <source>Tolerance, fig. 11</source>
        <translation>Tolérance, fig. 11</translation>
    </message>
    <message>
        <source>Twice the size, fig. 3.8</source>
        <translation>Taille double, fig. 3.8</translation>
    </message>
    <message>
        <source>Two directions</source>
        <translation>Deux directions</translation>
    </message>
    <message>
        <source>Figure 4.20 of Gutierrez&apos; thesis: the exemplar turned or not in each direction. Turns that agree where slices cross have the smallest loss, which is under Figures.</source>
        <translation>Figure 4.20 de la thèse de Gutierrez : l’échantillon tourné ou non dans chaque direction. Les rotations qui s’accordent là où les coupes se croisent ont la plus petite perte, indiquée sous Mesures.</translation>
    </message>
    <message>
        <source>The texture is made by the generator that was given, and the exemplar is not looked at; to teach it the exemplar, train it further.</source>
        <translation>La texture est faite par le générateur fourni ; l’échantillon n’est pas regardé. Pour le lui apprendre, poursuivez l’entraînement.</translation>
    </message>
    <message>
        <source>16, 81 and 256 tiles of two, three and four colours of corners (Ng and others 2005), the 16 of Cohen and others 2003 with coloured edges, and the 8 of their compact set. What strikes the eye comes back less often the more tiles there are.</source>
        <translation>16, 81 et 256 tuiles de deux, trois et quatre couleurs de coins (Ng et autres 2005), les 16 de Cohen et autres 2003 aux bords colorés, et les 8 de leur jeu compact. Ce qui frappe l’œil revient d’autant moins souvent qu’il y a plus de tuiles.</translation>
    </message>
    <message>
        <source>A full set has a tile for every combination of colours and can wrap; a compact one has two for whatever is above and to the left.</source>
        <translation>Un jeu complet a une tuile pour chaque combinaison de couleurs et peut se raccorder ; un jeu compact en a deux pour tout ce qui peut se trouver en haut et à gauche.</translation>
    </message>
    <message>
        <source>All tiles side by side; those of a full set match there.</source>
        <translation>Toutes les tuiles côte à côte ; celles d’un jeu complet s’y accordent.</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>Bords</translation>
    </message>
    <message>
        <source>Filling tiles</source>
        <translation>Remplissage des tuiles</translation>
    </message>
    <message>
        <source>How much companion maps, such as normals or heights, count where pieces are compared, joined and cut: at 1 as much as the image itself; 0 compares the image alone, and maps follow it.</source>
        <translation>Combien comptent les cartes associées, comme les normales ou les hauteurs, là où des morceaux sont comparés, joints et coupés : à 1 autant que l’image elle-même ; 0 ne compare que l’image, et les cartes la suivent.</translation>
    </message>
    <message>
        <source>How much worse than the best a tile may join itself and still be drawn: 0 takes the best whatever the seed, larger lets seeds differ.</source>
        <translation>De combien une tuile peut se raccorder moins bien que la meilleure et être tirée quand même : 0 prend la meilleure quelle que soit la graine, plus laisse les graines différer.</translation>
    </message>
    <message>
        <source>Kinds of corners, or of edges on each axis: more make more tiles, which repeat less and are harder to cut well.</source>
        <translation>Sortes de coins, ou de bords sur chaque axe : davantage donne plus de tuiles, qui se répètent moins et sont plus difficiles à bien couper.</translation>
    </message>
    <message>
        <source>Makes a small set of tiles that match by colours, and lays them without a period. Outputs of any size come in an instant, and any part of them alone; the set can be used by itself. Suits what has no large objects.</source>
        <translation>Fabrique un petit jeu de tuiles qui s’accordent par couleurs et les pose sans période. Des sorties de toute taille viennent aussitôt, et chaque partie à elle seule ; le jeu peut servir par lui-même. Convient à ce qui n’a pas de grands objets.</translation>
    </message>
    <message>
        <source>Match</source>
        <translation>Ce qui s’accorde</translation>
    </message>
    <message>
        <source>The colours of every tile&apos;s edges and corners, its place on the sheet, and the tile for each combination of colours; as .json for other programs.</source>
        <translation>Les couleurs des bords et des coins de chaque tuile, sa place sur la planche et la tuile de chaque combinaison de couleurs ; en .json pour d’autres programmes.</translation>
    </message>
    <message>
        <source>The first image is {} × {} px, the second {} × {} px: both are cropped to {} × {} px from the top left.</source>
        <translation>La première image fait {} × {} px, la seconde {} × {} px : toutes deux sont rognées à {} × {} px à partir du coin supérieur gauche.</translation>
    </message>
    <message>
        <source>The place that each pixel comes from, along the axis, with a grey line for what does not move, as in figure 5.30 of the thesis; of turbulence, squares as they are deformed.</source>
        <translation>L’endroit d’où vient chaque pixel, le long de l’axe, avec une ligne grise pour ce qui ne bouge pas, comme à la figure 5.30 de la thèse ; pour la turbulence, des carrés tels qu’ils sont déformés.</translation>
    </message>
    <message>
        <source>The tiles of Cohen, Shade, Hiller &amp; Deussen 2003: edges of two colours on each axis, four samples in diamonds, the 16 tiles of a full set.</source>
        <translation>Les tuiles de Cohen, Shade, Hiller &amp; Deussen 2003 : des bords de deux couleurs sur chaque axe, quatre échantillons en losanges, les 16 tuiles d’un jeu complet.</translation>
    </message>
    <message>
        <source>Wang tiles, as published</source>
        <translation>Tuiles de Wang, comme publié</translation>
    </message>
    <message>
        <source>Weight of companion maps</source>
        <translation>Poids des cartes</translation>
    </message>
    <message>
        <source>What has colours: corners, with fresh texture inside each tile, repeat less; edges are as published first, each tile four samples in diamonds.</source>
        <translation>Ce qui a des couleurs : des coins, avec de la texture neuve à l’intérieur de chaque tuile, se répètent moins ; des bords sont comme publié d’abord, chaque tuile faite de quatre échantillons en losanges.</translation>
    </message>
    <message>
        <source>What the run starts from has no companion maps, so their weight had no effect.</source>
        <translation>Ce dont le calcul part n’a pas de cartes associées, leur poids est donc resté sans effet.</translation>
    </message>
    <message>
        <source>Width of the zone in which the cuts may run, as a share of the tile: wider joins better.</source>
        <translation>Largeur de la zone où les coupes peuvent passer, en part de la tuile : plus large joint mieux.</translation>
    </message>
    <message>
        <source>a picture to blend</source>
        <translation>une image à fondre</translation>
    </message>
    <message>
        <source>a source of a run that waits</source>
        <translation>une source d’un calcul en attente</translation>
    </message>
    <message>
        <source>a source of the result that is shown</source>
        <translation>une source du résultat affiché</translation>
    </message>
    <message>
        <source>blend</source>
        <translation>fondu</translation>
    </message>
    <message>
        <source>contact sheet</source>
        <translation>planche-contact</translation>
    </message>
    <message>
        <source>open here</source>
        <translation>ouvert ici</translation>
    </message>
    <message>
        <source>part of the volume</source>
        <translation>partie du volume</translation>
    </message>
    <message>
        <source>picture of the material</source>
        <translation>image du matériau</translation>
    </message>
    <message>
        <source>picture of the turn</source>
        <translation>image de la rotation</translation>
    </message>
    <message>
        <source>the mesh that the material is shown on</source>
        <translation>le maillage sur lequel le matériau est affiché</translation>
    </message>
    <message>
        <source>the mesh that the volume is shown on</source>
        <translation>le maillage sur lequel le volume est affiché</translation>
    </message>
    <message>
        <source>the panorama that lights the material</source>
        <translation>le panorama qui éclaire le matériau</translation>
    </message>
    <message>
        <source>the session that is open</source>
        <translation>la session ouverte</translation>
    </message>
    <message>
        <source>the volume that is open</source>
        <translation>le volume ouvert</translation>
    </message>
    <message>
        <source>{} breaks off before its end marker, but all of its rows are there.</source>
        <translation>{} s’interrompt avant son marqueur de fin, mais toutes ses lignes sont là.</translation>
    </message>
    <message>
        <source>{} breaks off before the last of its scans, so that its picture lacks detail or colours; take a whole copy of it.</source>
        <translation>{} s’interrompt avant la dernière de ses passes, si bien qu’il manque à l’image des détails ou des couleurs ; prenez-en une copie complète.</translation>
    </message>
    <message>
        <source>{} goes into {}, which takes no picture, so it has no layer {}.</source>
        <translation>{0} va dans « {1} », qui ne prend pas d’image ; il n’y a donc pas de calque {2}.</translation>
    </message>
    <message>
        <source>{} holds data, but is compressed with loss ({}), which changes them; save such maps as PNG, or as EXR or TIFF with zip.</source>
        <translation>{0} contient des données, mais est compressé avec perte ({1}), ce qui les altère ; enregistrez ces cartes en PNG, ou en EXR ou TIFF avec zip.</translation>
    </message>
    <message>
        <source>{} is there, and Texloom did not write it; choose another name or folder.</source>
        <translation>{} existe déjà, et Texloom ne l’a pas écrit ; choisissez un autre nom ou dossier.</translation>
    </message>
    <message>
        <source>The mask leaves no whole neighbourhood of {} px, but only some of at most {} px; choose a smaller one or mask less.</source>
        <translation>Le masque ne laisse aucun voisinage entier de {} px, seulement d’au plus {} px ; choisissez-en un plus petit ou masquez moins.</translation>
    </message>
    <message>
        <source>The mask leaves no whole patch of {} px to copy, but only some of at most {} px; choose a smaller patch or mask less.</source>
        <translation>Le masque ne laisse aucun patch entier de {} px à copier, seulement d’au plus {} px ; choisissez un patch plus petit ou masquez moins.</translation>
    </message>
    <message>
        <source>Where a hole is filled with the stitch cut, moves the borders between what is copied to where they are seen least.</source>
        <translation>Là où un trou est rempli avec la couture cut, déplace les limites entre ce qui est copié là où elles se voient le moins.</translation>
    </message>
    <message>
        <source>Where a hole is filled with the stitch cut, takes the brightness and colour of what is copied from what is around it, as the stitch poisson does; off: every pixel is a copy.</source>
        <translation>Là où un trou est rempli avec la couture cut, la luminosité et la couleur de ce qui est copié suivent ce qui l’entoure, comme avec la couture poisson ; désactivé : chaque pixel est une copie.</translation>
    </message>
    <message>
        <source>1 channel</source>
        <translation>1 canal</translation>
    </message>
    <message>
        <source>Picture A of {} has {} and picture B {}; they need the same number.</source>
        <translation>L’image A de {} a {}, l’image B {} ; il en faut autant aux deux.</translation>
    </message>
    <message>
        <source>The dictionary was learnt from {}, and the exemplar with its companions has {}; they need the same number.</source>
        <translation>Le dictionnaire a été appris pour {}, et l’échantillon avec ses cartes associées en a {} ; il en faut autant.</translation>
    </message>
    <message>
        <source>The first image has {}, the second {}; they must have the same.</source>
        <translation>La première image a {}, la seconde {} ; il en faut autant.</translation>
    </message>
    <message>
        <source>The generator makes {}, and the exemplar has {}.</source>
        <translation>Le générateur fait {}, et l’échantillon en a {}.</translation>
    </message>
    <message>
        <source>The generator makes {}, and the exemplars have {}.</source>
        <translation>Le générateur fait {}, et les échantillons en ont {}.</translation>
    </message>
    <message>
        <source>The image to start from has {}, the output {}; they need the same number.</source>
        <translation>L’image de départ a {}, la sortie {} ; il en faut autant aux deux.</translation>
    </message>
    <message>
        <source>The target has {}, but the picture that corresponds to it for {} has {}; they are compared channel by channel, so give pictures of one kind.</source>
        <translation>La cible a {}, mais l’image qui lui correspond pour {} en a {} ; elles sont comparées canal par canal, donnez des images de même nature.</translation>
    </message>
    <message>
        <source>The target has {}, the exemplar {}; they need the same number.</source>
        <translation>La cible a {}, l’échantillon {} ; il en faut le même nombre.</translation>
    </message>
    <message>
        <source>repeats after {} voxels, {}</source>
        <translation>se répète après {} voxels, {}</translation>
    </message>
    <message>
        <source>without end, {}</source>
        <translation>sans fin, {}</translation>
    </message>
    <message>
        <source>{} channels</source>
        <translation>{} canaux</translation>
    </message>
    <message>
        <source>{} has {}; there is no channel {}.</source>
        <translation>{} a {} ; il n’y a pas de canal {}.</translation>
    </message>
    <message>
        <source>{} is {} × {} px with {}; the volume&apos;s first slice {} is {} × {} px with {}.</source>
        <translation>{} fait {} × {} px et a {} ; la première coupe {} du volume fait {} × {} px et en a {}.</translation>
    </message>
    <message>
        <source>{} needs its input {}, which was not given.</source>
        <translation>{} a besoin de l’entrée {}, qui n’a pas été donnée.</translation>
    </message>
    <message>
        <source>{} voxels, {}</source>
        <translation>{} voxels, {}</translation>
    </message>
    <message>
        <source>8 or 16</source>
        <translation>8 ou 16</translation>
    </message>
    <message>
        <source>A file of the export preset has no word for $map.</source>
        <translation>Un fichier du préréglage d’export n’a pas de mot pour $map.</translation>
    </message>
    <message>
        <source>How much a small tile that repeats often is preferred to a large one that fits better when a lattice is looked for: 1 not at all, larger finds smaller tiles.</source>
        <translation>À quel point, lorsqu’un réseau est cherché, une petite tuile souvent répétée est préférée à une grande qui convient mieux : 1 pas du tout, plus grand trouve de plus petites tuiles.</translation>
    </message>
    <message>
        <source>Overlap that counts</source>
        <translation>Recouvrement retenu</translation>
    </message>
    <message>
        <source>Smaller tiles</source>
        <translation>Tuiles plus petites</translation>
    </message>
    <message>
        <source>The export preset is of format {}, made by a newer Texloom; this one ({}) reads up to {}.</source>
        <translation>Le préréglage d’export est au format {}, d’un Texloom plus récent ; celui-ci ({}) lit jusqu’à {}.</translation>
    </message>
    <message>
        <source>The export preset needs a name.</source>
        <translation>Il faut un nom au préréglage d’export.</translation>
    </message>
    <message>
        <source>The names of files need $map, so that the maps&apos; names differ.</source>
        <translation>Les noms des fichiers ont besoin de $map, pour que ceux des cartes diffèrent.</translation>
    </message>
    <message>
        <source>The names of files need a letter or a word, such as $name.</source>
        <translation>Les noms des fichiers ont besoin d’une lettre ou d’un mot, comme $name.</translation>
    </message>
    <message>
        <source>The share of a tile by which the exemplar must overlap itself for a repetition to count when a lattice is looked for: smaller counts those near its ends, which tell less, and finds larger tiles.</source>
        <translation>La part d’une tuile dont l’échantillon doit se recouvrir lui-même pour qu’une répétition compte lorsqu’un réseau est cherché : plus petite, elle retient celles proches des bords, qui disent moins, et trouve de plus grandes tuiles.</translation>
    </message>
    <message>
        <source>Two files of the export preset have the word {} for $map; give them different ones.</source>
        <translation>Deux fichiers du préréglage d’export ont le mot {} pour $map ; donnez-leur des mots différents.</translation>
    </message>
    <message>
        <source>as-they-are, up or down</source>
        <translation>as-they-are, up ou down</translation>
    </message>
    <message>
        <source>export preset</source>
        <translation>préréglage d’export</translation>
    </message>
    <message>
        <source>{} holds a slash, which no file&apos;s name can.</source>
        <translation>{} contient une barre oblique, ce qu’aucun nom de fichier ne peut.</translation>
    </message>
    <message>
        <source>{} would be overwritten by the {}: it is {}; name another file.</source>
        <translation>{0} serait écrasé ({1}), et c&apos;est {2} ; nommez un autre fichier.</translation>
    </message>
    <message>
        <source>Bounded</source>
        <translation>Borné</translation>
    </message>
    <message>
        <source>Continues what is there: every patch is drawn from the Gaussian of similar ones, given the pixels next to it. Suits grain, gravel and brick; patches are not stitched, so that their borders show on smooth objects such as scales or roof tiles.</source>
        <translation>Prolonge ce qui est là : chaque patch est tiré de la gaussienne de ses semblables, sachant les pixels voisins. Convient au grain, au gravier et à la brique ; les patchs ne sont pas raccordés, si bien que leurs bords se voient sur des objets lisses comme des écailles ou des tuiles.</translation>
    </message>
    <message>
        <source>Given border</source>
        <translation>Bord donné</translation>
    </message>
    <message>
        <source>How far flat patches are kept from winning where nothing fits well, and how far a sample gets the contrast of the patches that it is drawn from: 1 holds the exemplar&apos;s contrast; 0 is as published, and outputs fade.</source>
        <translation>À quel point les patchs plats sont empêchés de gagner là où rien ne convient, et un tirage reçoit le contraste des patchs dont il est tiré : 1 tient le contraste de l’échantillon ; 0 est comme publié, et les résultats s’affadissent.</translation>
    </message>
    <message>
        <source>How wide a border of what is there a patch is drawn to continue: narrow keeps the exemplar&apos;s contrast, wide fits more closely and fades; 0 gives all of it, as published.</source>
        <translation>Largeur du bord de ce qui est là qu’un patch prolonge : étroit, il garde le contraste de l’échantillon ; large, il s’ajuste mieux et s’affadit ; 0 donne tout, comme publié.</translation>
    </message>
    <message>
        <source>Keeps each pixel of a new patch within the lightness and colour that the patches like it have there: no sparks and no false colours. Off: the Gaussian as published.</source>
        <translation>Garde chaque pixel d’un nouveau patch dans la clarté et la couleur que les patchs semblables y ont : ni étincelles ni fausses couleurs. Désactivé : la gaussienne comme publiée.</translation>
    </message>
    <message>
        <source>It was left out when Texloom was built; build it with -DTEXLOOM_NETWORKS=ON.</source>
        <translation>Elle a été omise à la construction de Texloom ; construisez-le avec -DTEXLOOM_NETWORKS=ON.</translation>
    </message>
    <message>
        <source>No lattice was found in {} (confidence {:.0f} %; a vector must fit about twice), so it was treated as a texture that does not repeat. If it does, rectify it where it is seen at an angle, or give its vectors yourself; if it does not, image quilting may suit it better.</source>
        <translation>Aucun réseau n’a été trouvé dans {} (confiance {:.0f} % ; un vecteur doit y tenir environ deux fois) ; elle a donc été traitée comme une texture sans répétition. Si elle se répète, redressez-la là où elle est vue de biais, ou donnez vous-même ses vecteurs ; sinon, le quilting d’images conviendra peut-être mieux.</translation>
    </message>
    <message>
        <source>Nothing in {} repeats about twice, so it was treated as a texture that does not repeat. If it does, rectify it where it is seen at an angle, or give its vectors yourself; if it does not, image quilting may suit it better.</source>
        <translation>Rien dans {} ne se répète environ deux fois ; elle a donc été traitée comme une texture sans répétition. Si elle se répète, redressez-la là où elle est vue de biais, ou donnez vous-même ses vecteurs ; sinon, le quilting d’images conviendra peut-être mieux.</translation>
    </message>
    <message>
        <source>Nothing in {} repeats, but rows run through all of it: they keep the order that they have there, and begin again every {:.0f} px. If it does repeat, rectify it where it is seen at an angle, or give its vectors yourself.</source>
        <translation>Rien dans {} ne se répète, mais des rangées la traversent entièrement : elles gardent l’ordre qu’elles y ont et recommencent tous les {:.0f} px. Si elle se répète, redressez-la là où elle est vue de biais, ou donnez vous-même ses vecteurs.</translation>
    </message>
    <message>
        <source>At most so many, each half the size of the one before: a finer one sees the coarser one&apos;s result where it has made nothing yet, so that large structures are kept, and what grows from opposite sides meets. 1 grows as published.</source>
        <translation>Au plus autant, chacune deux fois plus petite que la précédente : une échelle plus fine voit le résultat de la plus grossière là où elle n’a encore rien fait, de sorte que les grandes structures sont gardées et que ce qui croît de côtés opposés se rejoint. 1 croît comme publié.</translation>
    </message>
    <message>
        <source>Compares all windows exactly, or only those that are likely by their principal components, in time that hardly grows with the exemplar. Automatic: all on the coarsest scale, or the likely ones of large exemplars, and on finer scales those near the coarser one&apos;s sources.</source>
        <translation>Compare exactement toutes les fenêtres, ou seulement celles que leurs composantes principales rendent probables, en un temps qui ne croît guère avec l’échantillon. Automatique : toutes à l’échelle la plus grossière, ou les probables des grands échantillons, et aux échelles plus fines celles proches des sources de la plus grossière.</translation>
    </message>
    <message>
        <source>Efros–Leung, as published</source>
        <translation>Efros–Leung, comme publié</translation>
    </message>
    <message>
        <source>Grows the output pixel by pixel, from coarse to fine; each becomes one of the exemplar&apos;s whose surroundings fit what is around it. Faithful to small structures and large ones. With one scale, as published, it is slow, and a window of the wrong size grows garbage or copies verbatim.</source>
        <translation>Fait croître le résultat pixel par pixel, du grossier au fin ; chacun devient un pixel de l’échantillon dont les alentours s’accordent à ce qui l’entoure. Fidèle aux petites structures comme aux grandes. Avec une seule échelle, comme publié, la méthode est lente, et une fenêtre de mauvaise taille engendre du désordre ou copie mot à mot.</translation>
    </message>
    <message>
        <source>Moves the borders between what is copied to where they are seen least, so that few large pieces take the place of many small ones; where a whole output grows, on coarse scales only.</source>
        <translation>Déplace les bords entre ce qui est copié là où ils se voient le moins, de sorte que quelques grands morceaux remplacent beaucoup de petits ; là où un résultat entier croît, seulement aux échelles grossières.</translation>
    </message>
    <message>
        <source>The settings of Efros &amp; Leung, ICCV 1999, as Aguerrebere, Gousseau &amp; Tartavel give them (IPOL 2013): one scale, windows of 11 px, a tolerance of 0.1 and weights of 1 / 6.4 of the window.</source>
        <translation>Les réglages d’Efros &amp; Leung, ICCV 1999, tels qu’Aguerrebere, Gousseau &amp; Tartavel les donnent (IPOL 2013) : une échelle, des fenêtres de 11 px, une tolérance de 0,1 et des poids de 1 / 6,4 de la fenêtre.</translation>
    </message>
    <message>
        <source>Figures 2.1, 2.4 and 2.5 of Raad&apos;s thesis: patches of 10, 20 and 30 px from 10, 20 and 30 neighbours, replaced in the exemplar itself, then grown; and maps of where each pixel comes from, in which a copied piece is a smooth patch of colour.</source>
        <translation>Figures 2.1, 2.4 et 2.5 de la thèse de Raad : des patchs de 10, 20 et 30 px à partir de 10, 20 et 30 voisins, remplacés dans l’échantillon même, puis posés l’un après l’autre ; et des cartes de l’origine de chaque pixel, où un morceau copié est une plage de couleur lisse.</translation>
    </message>
    <message>
        <source>Gaussian patches: patch and neighbours</source>
        <translation>Patchs gaussiens : patch et voisins</translation>
    </message>
    <message>
        <source>Grown, fig. 2.4</source>
        <translation>Posés l’un après l’autre, fig. 2.4</translation>
    </message>
    <message>
        <source>Locally Gaussian and its map, fig. 2.5</source>
        <translation>Localement gaussien et sa carte, fig. 2.5</translation>
    </message>
    <message>
        <source>Patches replaced, fig. 2.1</source>
        <translation>Patchs remplacés, fig. 2.1</translation>
    </message>
    <message>
        <source>Quilting and its map, fig. 2.5</source>
        <translation>Quilting et sa carte, fig. 2.5</translation>
    </message>
    <message>
        <source>At the finest scale, and up to four times as many at coarser ones: more bring the patches closer to the exemplar&apos;s.</source>
        <translation>À l’échelle la plus fine, et jusqu’à quatre fois plus aux échelles plus grossières : davantage rapproche les patchs de ceux de l’échantillon.</translation>
    </message>
</context>
<context>
    <name>files</name>
    <message>
        <source>Pictures, materials and recipes (%1 *.zip *.json);;All files (*)</source>
        <translation>Images, matériaux et recettes (%1 *.zip *.json);;Tous les fichiers (*)</translation>
    </message>
</context>
<context>
    <name>main</name>
    <message>
        <source>A workbench for exemplar-based texture synthesis.</source>
        <translation>Un atelier de synthèse de textures par l’échantillon.</translation>
    </message>
    <message>
        <source>Exemplars, a recipe or a session to open.</source>
        <translation>Échantillons, recette ou session à ouvrir.</translation>
    </message>
</context>
<context>
    <name>texloom::ui</name>
    <message>
        <source>%1 · seed %2 · %3</source>
        <translation>%1 · graine %2 · %3</translation>
    </message>
    <message>
        <source>seed %1</source>
        <translation>graine %1</translation>
    </message>
    <message>
        <source>preview</source>
        <translation>aperçu</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Méthode</translation>
    </message>
    <message>
        <source>Exemplars</source>
        <translation>Échantillons</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Graine</translation>
    </message>
    <message>
        <source>Made</source>
        <translation>Créé</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>on</source>
        <translation>activé</translation>
    </message>
    <message>
        <source>off</source>
        <translation>désactivé</translation>
    </message>
    <message>
        <source>%1 at %2, %3</source>
        <translation>%1 en %2, %3</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1 : %2</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Arrêté</translation>
    </message>
    <message>
        <source>at %1 of the work</source>
        <translation>à %1 du travail</translation>
    </message>
    <message>
        <source>It cannot go on, since these files changed after it began: %1.</source>
        <translation>Il ne peut pas continuer, car ces fichiers ont changé depuis son début : %1.</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>from %1</source>
        <translation>à partir de %1</translation>
    </message>
</context>
<context>
    <name>texloom::ui::Actions</name>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Ouvrir…</translation>
    </message>
    <message>
        <source>Open exemplars or a recipe</source>
        <translation>Ouvrir des échantillons ou une recette</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>&amp;Coller</translation>
    </message>
    <message>
        <source>Paste a picture or a file as an exemplar</source>
        <translation>Coller une image ou un fichier comme échantillon</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exporter…</translation>
    </message>
    <message>
        <source>Write the result and its maps to files</source>
        <translation>Écrire le résultat et ses cartes dans des fichiers</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Quitter</translation>
    </message>
    <message>
        <source>&amp;Copy result</source>
        <translation>&amp;Copier le résultat</translation>
    </message>
    <message>
        <source>Copy the result as a picture</source>
        <translation>Copier le résultat comme image</translation>
    </message>
    <message>
        <source>Set &amp;mask…</source>
        <translation>Définir un &amp;masque…</translation>
    </message>
    <message>
        <source>&amp;Clear mask</source>
        <translation>&amp;Effacer le masque</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Retirer</translation>
    </message>
    <message>
        <source>Take the exemplar off the list; its file stays</source>
        <translation>Retirer l’échantillon de la liste ; son fichier reste</translation>
    </message>
    <message>
        <source>E&amp;dit…</source>
        <translation>Re&amp;toucher…</translation>
    </message>
    <message>
        <source>Crop, turn, rectify, even out the light, hide parts</source>
        <translation>Recadrer, tourner, redresser, égaliser la lumière, masquer des parties</translation>
    </message>
    <message>
        <source>Add companion &amp;maps…</source>
        <translation>Ajouter des &amp;cartes associées…</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>&amp;Lancer</translation>
    </message>
    <message>
        <source>Make the result; if a run is under way, right after it, but a quick preview gives way</source>
        <translation>Produire le résultat ; si un calcul est en cours, juste après, mais un aperçu rapide cède la place</translation>
    </message>
    <message>
        <source>&amp;Add to queue</source>
        <translation>&amp;Ajouter à la file</translation>
    </message>
    <message>
        <source>Make the result with these settings after all runs that wait</source>
        <translation>Produire le résultat avec ces réglages après tout ce qui attend</translation>
    </message>
    <message>
        <source>&amp;Quick</source>
        <translation>&amp;Rapide</translation>
    </message>
    <message>
        <source>Make a small preview with the same settings</source>
        <translation>Produire un petit aperçu avec les mêmes réglages</translation>
    </message>
    <message>
        <source>&amp;New seed and run</source>
        <translation>&amp;Nouvelle graine et lancer</translation>
    </message>
    <message>
        <source>Reset all &amp;parameters</source>
        <translation>Réinitialiser tous les &amp;paramètres</translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation>A&amp;juster</translation>
    </message>
    <message>
        <source>Fit the picture in the view</source>
        <translation>Ajuster l’image à la vue</translation>
    </message>
    <message>
        <source>&amp;100 %</source>
        <translation>&amp;100 %</translation>
    </message>
    <message>
        <source>One screen pixel for each of the picture&apos;s</source>
        <translation>Un pixel d’écran par pixel de l’image</translation>
    </message>
    <message>
        <source>Zoom &amp;in</source>
        <translation>Zoom a&amp;vant</translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation>Zoom a&amp;rrière</translation>
    </message>
    <message>
        <source>&amp;Repeat</source>
        <translation>&amp;Répéter</translation>
    </message>
    <message>
        <source>Show the picture repeated on all sides</source>
        <translation>Montrer l’image répétée de tous côtés</translation>
    </message>
    <message>
        <source>R&amp;esult</source>
        <translation>R&amp;ésultat</translation>
    </message>
    <message>
        <source>&amp;Synthesis map</source>
        <translation>Carte de &amp;synthèse</translation>
    </message>
    <message>
        <source>&amp;Position map</source>
        <translation>Carte de &amp;positions</translation>
    </message>
    <message>
        <source>Reset &amp;layout</source>
        <translation>Rétablir la &amp;disposition</translation>
    </message>
    <message>
        <source>F&amp;ull screen</source>
        <translation>Plein &amp;écran</translation>
    </message>
    <message>
        <source>&amp;Keyboard shortcuts</source>
        <translation>&amp;Raccourcis clavier</translation>
    </message>
    <message>
        <source>&amp;About Texloom</source>
        <translation>À &amp;propos de Texloom</translation>
    </message>
    <message>
        <source>&amp;Copied pieces</source>
        <translation>Morceaux &amp;copiés</translation>
    </message>
    <message>
        <source>&amp;Lattice</source>
        <translation>&amp;Réseau</translation>
    </message>
    <message>
        <source>Find or set the vectors by which the exemplar repeats itself</source>
        <translation>Trouver ou fixer les vecteurs selon lesquels l’échantillon se répète</translation>
    </message>
    <message>
        <source>&amp;Blend two images…</source>
        <translation>&amp;Fondre deux images…</translation>
    </message>
    <message>
        <source>Join two images along a curve</source>
        <translation>Joindre deux images le long d’une courbe</translation>
    </message>
    <message>
        <source>Patch &amp;variance…</source>
        <translation>&amp;Variance des patchs…</translation>
    </message>
    <message>
        <source>How much patches vary that are alike, by their size and number</source>
        <translation>À quel point varient des patchs semblables, selon leur taille et leur nombre</translation>
    </message>
    <message>
        <source>&amp;Half offset</source>
        <translation>&amp;Demi-décalage</translation>
    </message>
    <message>
        <source>Show the picture repeated, with the corner where its tiles meet in the middle</source>
        <translation>Montrer l’image répétée, le coin où se joignent les carreaux au milieu</translation>
    </message>
    <message>
        <source>&amp;Stress test…</source>
        <translation>Épreuve d’&amp;endurance…</translation>
    </message>
    <message>
        <source>Make a texture of the texture of the texture, to see what the method loses</source>
        <translation>Faire une texture de la texture de la texture, pour voir ce que la méthode perd</translation>
    </message>
    <message>
        <source>&amp;Stop and keep</source>
        <translation>&amp;Arrêter et garder</translation>
    </message>
    <message>
        <source>End the run under way and keep what is there as a result; those that wait go on</source>
        <translation>Terminer le calcul en cours et garder ce qui est là comme résultat ; ceux qui attendent continuent</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Arrêter</translation>
    </message>
    <message>
        <source>&amp;Cancel run</source>
        <translation>Ann&amp;uler le calcul</translation>
    </message>
    <message>
        <source>End the run under way and keep nothing of it; those that wait go on</source>
        <translation>Terminer le calcul en cours sans rien en garder ; ceux qui attendent continuent</translation>
    </message>
    <message>
        <source>E&amp;xtend a picture…</source>
        <translation>&amp;Étendre une image…</translation>
    </message>
    <message>
        <source>Make more of a picture beyond its edges, with a method that completes pictures</source>
        <translation>Prolonger une image au-delà de ses bords, avec une méthode qui complète des images</translation>
    </message>
    <message>
        <source>Export a&amp;gain</source>
        <translation>Exporter de nou&amp;veau</translation>
    </message>
    <message>
        <source>Write the result to the folder and in the way of the last export, without asking</source>
        <translation>Écrire le résultat dans le dossier et de la façon du dernier export, sans demander</translation>
    </message>
    <message>
        <source>&amp;Navigator</source>
        <translation>&amp;Navigateur</translation>
    </message>
    <message>
        <source>Show the whole picture small where a part of it is shown, or hide it</source>
        <translation>Montrer toute l&apos;image en petit là où l&apos;on n&apos;en voit qu&apos;une partie, ou la cacher</translation>
    </message>
    <message>
        <source>H&amp;istogram, waveform</source>
        <translation>H&amp;istogramme, forme d&apos;onde</translation>
    </message>
    <message>
        <source>Show the histogram of the picture, then its waveform, then neither</source>
        <translation>Montrer l&apos;histogramme de l&apos;image, puis sa forme d&apos;onde, puis aucun des deux</translation>
    </message>
    <message>
        <source>Stac&amp;k panels</source>
        <translation>E&amp;mpiler les panneaux</translation>
    </message>
    <message>
        <source>Put all panels on one another at the right, as on small screens</source>
        <translation>Superpose tous les panneaux à droite, comme sur les petits écrans</translation>
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
        <translation>Échantillon</translation>
    </message>
    <message>
        <source>B′</source>
        <translation>B′</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Résultat</translation>
    </message>
    <message>
        <source>&lt;b&gt;A′&lt;/b&gt; The exemplar, which stands to A as the result will stand to B. A click opens another one.</source>
        <translation>&lt;b&gt;A′&lt;/b&gt; L’échantillon, qui est à A ce que le résultat sera à B. Un clic en ouvre un autre.</translation>
    </message>
    <message>
        <source>A′: open another exemplar</source>
        <translation>A′ : ouvrir un autre échantillon</translation>
    </message>
    <message>
        <source>&lt;b&gt;B′&lt;/b&gt; The result, made from A, A′ and B. A click shows it.</source>
        <translation>&lt;b&gt;B′&lt;/b&gt; Le résultat, fait de A, A′ et B. Un clic le montre.</translation>
    </message>
    <message>
        <source>B′: show the result</source>
        <translation>B′ : montrer le résultat</translation>
    </message>
    <message>
        <source>Open the result that is shown as an exemplar</source>
        <translation>Ouvrir le résultat affiché comme échantillon</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>Rien</translation>
    </message>
    <message>
        <source>Not made yet</source>
        <translation>Pas encore fait</translation>
    </message>
</context>
<context>
    <name>texloom::ui::BlendWindow</name>
    <message>
        <source>Show the cur&amp;ve and its band</source>
        <translation>Montrer la cour&amp;be et sa bande</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Enregistrer</translation>
    </message>
    <message>
        <source>Open as e&amp;xemplar</source>
        <translation>Ouvrir comme é&amp;chantillon</translation>
    </message>
    <message>
        <source>Blend two images</source>
        <translation>Fondre deux images</translation>
    </message>
    <message>
        <source>&amp;First</source>
        <translation>&amp;Première</translation>
    </message>
    <message>
        <source>S&amp;econd</source>
        <translation>&amp;Seconde</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Montrer</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Ouvrir…</translation>
    </message>
    <message>
        <source>Open a file as the first image</source>
        <translation>Ouvrir un fichier comme première image</translation>
    </message>
    <message>
        <source>Open a file as the second image</source>
        <translation>Ouvrir un fichier comme seconde image</translation>
    </message>
    <message>
        <source>%1…</source>
        <translation>%1…</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Open an image</source>
        <translation>Ouvrir une image</translation>
    </message>
    <message>
        <source>Tick at least one way to show.</source>
        <translation>Cochez au moins une façon à montrer.</translation>
    </message>
    <message>
        <source>Blending…</source>
        <translation>Fondu en cours…</translation>
    </message>
    <message>
        <source>%1 and %2.png</source>
        <translation>%1 et %2.png</translation>
    </message>
    <message>
        <source>Save the blend</source>
        <translation>Enregistrer le fondu</translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.tif *.exr *.hdr)</source>
        <translation>Images (*.png *.jpg *.tif *.exr *.hdr)</translation>
    </message>
    <message>
        <source>Wrote %1.</source>
        <translation>%1 écrit.</translation>
    </message>
    <message>
        <source>Reading “%1”…</source>
        <translation>Lecture de « %1 »…</translation>
    </message>
    <message>
        <source>&amp;Tool</source>
        <translation>&amp;Outil</translation>
    </message>
    <message>
        <source>Choose two images.</source>
        <translation>Choisissez deux images.</translation>
    </message>
    <message>
        <source>Stopped. The pictures are those of earlier settings; any change starts again.</source>
        <translation>Arrêté. Les images sont celles de réglages antérieurs ; tout changement recommence.</translation>
    </message>
    <message>
        <source>Open two images to blend.</source>
        <translation>Ouvrez deux images à fondre.</translation>
    </message>
    <message>
        <source>Both images are “%1”. Open or choose another one to blend it with.</source>
        <translation>Les deux images sont « %1 ». Ouvrez ou choisissez-en une autre pour la fondre avec.</translation>
    </message>
    <message>
        <source>“%1” is %2 px, “%3” is %4 px: both are cropped to %5 px from the top left.</source>
        <translation>« %1 » fait %2 px, « %3 » fait %4 px : les deux sont recadrées à %5 px depuis le coin supérieur gauche.</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>&amp;Paint the region…</source>
        <translation>&amp;Peindre la région…</translation>
    </message>
    <message>
        <source>Show the re&amp;gion’s outline</source>
        <translation>Montrer le contour de la ré&amp;gion</translation>
    </message>
</context>
<context>
    <name>texloom::ui::BoxDialog</name>
    <message>
        <source>Box of voxels</source>
        <translation>Boîte de voxels</translation>
    </message>
    <message>
        <source>First voxel</source>
        <translation>Premier voxel</translation>
    </message>
    <message>
        <source>Voxels</source>
        <translation>Voxels</translation>
    </message>
    <message>
        <source>First voxel along %1</source>
        <translation>Premier voxel le long de %1</translation>
    </message>
    <message>
        <source>Voxels along %1</source>
        <translation>Voxels le long de %1</translation>
    </message>
    <message>
        <source>%1 voxels</source>
        <translation>%1 voxels</translation>
    </message>
</context>
<context>
    <name>texloom::ui::CandidateTable</name>
    <message>
        <source>Lattices to choose from</source>
        <translation>Réseaux au choix</translation>
    </message>
    <message>
        <source>Goodness</source>
        <translation>Qualité</translation>
    </message>
    <message>
        <source>free</source>
        <translation>libre</translation>
    </message>
    <message>
        <source>Only rows repeat: what lies along them comes from anywhere in a row</source>
        <translation>Seules des rangées se répètent : ce qu’elles contiennent vient de n’importe où dans une rangée</translation>
    </message>
    <message>
        <source>Mean correlation %1 over %2 multiples of the vectors</source>
        <translation>Corrélation moyenne %1 sur %2 multiples des vecteurs</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Résultat</translation>
    </message>
    <message>
        <source>A small result with this lattice</source>
        <translation>Un petit résultat avec ce réseau</translation>
    </message>
    <message>
        <source>Vectors</source>
        <translation>Vecteurs</translation>
    </message>
</context>
<context>
    <name>texloom::ui::CompanionList</name>
    <message>
        <source>Companion maps</source>
        <translation>Cartes associées</translation>
    </message>
    <message>
        <source>What the map holds</source>
        <translation>Ce que contient la carte</translation>
    </message>
    <message>
        <source>What the map holds. Normals turn with the exemplar.</source>
        <translation>Ce que contient la carte. Les normales tournent avec l’échantillon.</translation>
    </message>
    <message>
        <source>Add…</source>
        <translation>Ajouter…</translation>
    </message>
    <message>
        <source>Add companion maps</source>
        <translation>Ajouter des cartes associées</translation>
    </message>
    <message>
        <source>Add maps of the exemplar&apos;s size, such as normals or heights: they get the result&apos;s layout.</source>
        <translation>Ajouter des cartes de la taille de l’échantillon, normales ou hauteurs par exemple : elles prennent la disposition du résultat.</translation>
    </message>
    <message>
        <source>Remove the map</source>
        <translation>Retirer la carte</translation>
    </message>
    <message>
        <source>None yet</source>
        <translation>Pas encore</translation>
    </message>
    <message>
        <source>Drop maps such as bark_normal and bark_rough with bark, or add them.</source>
        <translation>Déposez des cartes comme bark_normal et bark_rough avec bark, ou ajoutez-les.</translation>
    </message>
    <message>
        <source>red</source>
        <translation>rouge</translation>
    </message>
    <message>
        <source>green</source>
        <translation>vert</translation>
    </message>
    <message>
        <source>blue</source>
        <translation>bleu</translation>
    </message>
    <message>
        <source>alpha</source>
        <translation>alpha</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>channel %1</source>
        <translation>canal %1</translation>
    </message>
    <message>
        <source>%1, inverted</source>
        <translation>%1, inversé</translation>
    </message>
    <message>
        <source>%1, derived</source>
        <translation>%1, dérivée</translation>
    </message>
    <message>
        <source>%1, layer %2</source>
        <translation>%1, calque %2</translation>
    </message>
</context>
<context>
    <name>texloom::ui::CompareActions</name>
    <message>
        <source>&amp;Grid</source>
        <translation>&amp;Grille</translation>
    </message>
    <message>
        <source>Compare pictures side by side</source>
        <translation>Comparer des images côte à côte</translation>
    </message>
    <message>
        <source>&amp;Wipe</source>
        <translation>&amp;Volet</translation>
    </message>
    <message>
        <source>Compare two pictures in one place, parted by a line</source>
        <translation>Comparer deux images au même endroit, séparées par une ligne</translation>
    </message>
    <message>
        <source>&amp;Toggle</source>
        <translation>&amp;Alterner</translation>
    </message>
    <message>
        <source>Compare two pictures in one place, one after the other</source>
        <translation>Comparer deux images au même endroit, l’une après l’autre</translation>
    </message>
    <message>
        <source>&amp;Difference</source>
        <translation>&amp;Différence</translation>
    </message>
    <message>
        <source>Show what two pictures differ in</source>
        <translation>Montrer en quoi deux images diffèrent</translation>
    </message>
    <message>
        <source>E&amp;xemplar</source>
        <translation>É&amp;chantillon</translation>
    </message>
    <message>
        <source>&amp;Link views</source>
        <translation>&amp;Lier les vues</translation>
    </message>
    <message>
        <source>Zoom and move all pictures together; those moved apart before stay apart as they are</source>
        <translation>Zoomer et déplacer toutes les images ensemble ; celles décalées avant gardent leur décalage</translation>
    </message>
    <message>
        <source>&amp;Contact sheet…</source>
        <translation>&amp;Planche-contact…</translation>
    </message>
    <message>
        <source>Write all pictures with their labels into one PNG file</source>
        <translation>Écrire toutes les images et leurs légendes dans un fichier PNG</translation>
    </message>
    <message>
        <source>Show the exemplars of the results beside them</source>
        <translation>Montrer les modèles des résultats à côté d’eux</translation>
    </message>
    <message>
        <source>Open e&amp;xemplars</source>
        <translation>Modèles o&amp;uverts</translation>
    </message>
    <message>
        <source>With its &amp;input</source>
        <translation>Avec son en&amp;trée</translation>
    </message>
    <message>
        <source>Compare the result that is shown with the image that it was made from</source>
        <translation>Comparer le résultat affiché à l’image dont il est fait</translation>
    </message>
</context>
<context>
    <name>texloom::ui::CompareBar</name>
    <message>
        <source>First picture</source>
        <translation>Première image</translation>
    </message>
    <message>
        <source>Second picture</source>
        <translation>Seconde image</translation>
    </message>
    <message>
        <source>Kind of difference</source>
        <translation>Type de différence</translation>
    </message>
    <message>
        <source>Absolute</source>
        <translation>Absolue</translation>
    </message>
    <message>
        <source>Squared</source>
        <translation>Au carré</translation>
    </message>
    <message>
        <source>Relative</source>
        <translation>Relative</translation>
    </message>
    <message>
        <source> EV</source>
        <translation> EV</translation>
    </message>
    <message>
        <source>Exposure in stops</source>
        <translation>Exposition en diaphragmes</translation>
    </message>
    <message>
        <source>Brightens or darkens all pictures on the screen; each stop doubles the light</source>
        <translation>Éclaircit ou assombrit toutes les images à l’écran ; chaque diaphragme double la lumière</translation>
    </message>
    <message>
        <source>Channel shown</source>
        <translation>Canal montré</translation>
    </message>
    <message>
        <source>The channel shown of all pictures (Shift+C, R, G, B, A)</source>
        <translation>Le canal montré de toutes les images (Maj+C, R, G, B, A)</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Couleur</translation>
    </message>
    <message>
        <source>Red</source>
        <translation>Rouge</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>Vert</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>Bleu</translation>
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
        <translation>Reprendre les réglages de ce résultat dans le formulaire (Entrée) ; Lancer le produit ensuite en pleine taille</translation>
    </message>
    <message>
        <source>Restore settings</source>
        <translation>Rétablir les réglages</translation>
    </message>
    <message>
        <source>Restore the settings of %1</source>
        <translation>Rétablir les réglages de %1</translation>
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
        <translation>différence relative moyenne %1</translation>
    </message>
    <message>
        <source>mean absolute difference %1</source>
        <translation>différence absolue moyenne %1</translation>
    </message>
    <message>
        <source>%1 over the %2 px that both have</source>
        <translation>%1 sur les %2 px que les deux ont</translation>
    </message>
    <message>
        <source>Comparison</source>
        <translation>Comparaison</translation>
    </message>
    <message>
        <source>Two pictures are needed; choose them above.</source>
        <translation>Il faut deux images ; choisissez-les ci-dessus.</translation>
    </message>
    <message>
        <source>Choose results in the Results dock and press Compare, or Try all methods in the Synthesis menu.</source>
        <translation>Choisissez des résultats dans le volet Résultats et cliquez sur Comparer, ou essayez toutes les méthodes dans le menu Synthèse.</translation>
    </message>
</context>
<context>
    <name>texloom::ui::Comparisons</name>
    <message>
        <source>&amp;Compare</source>
        <translation>&amp;Comparer</translation>
    </message>
    <message>
        <source>This result was removed.</source>
        <translation>Ce résultat a été retiré.</translation>
    </message>
    <message>
        <source>%1 · exemplar · %2</source>
        <translation>%1 · échantillon · %2</translation>
    </message>
    <message>
        <source>No exemplar is open</source>
        <translation>Aucun modèle n’est ouvert</translation>
    </message>
    <message>
        <source>Write a contact sheet</source>
        <translation>Écrire une planche-contact</translation>
    </message>
    <message>
        <source>PNG pictures (*.png)</source>
        <translation>Images PNG (*.png)</translation>
    </message>
    <message>
        <source>Wrote %1.</source>
        <translation>%1 écrit.</translation>
    </message>
    <message>
        <source>There is no result yet that could be compared; press Run first.</source>
        <translation>Il n’y a pas encore de résultat à comparer ; lancez d’abord un calcul.</translation>
    </message>
    <message>
        <source>This result was not made from an image beside the exemplar; show one that completes or changes an image.</source>
        <translation>Ce résultat n’a pas été fait d’une image autre que l’échantillon ; affichez-en un qui complète ou modifie une image.</translation>
    </message>
</context>
<context>
    <name>texloom::ui::DifferenceDialog</name>
    <message>
        <source>Differences in settings</source>
        <translation>Différences de réglages</translation>
    </message>
    <message>
        <source>Setting</source>
        <translation>Réglage</translation>
    </message>
    <message>
        <source>Both were made with the same settings, so they are the same.</source>
        <translation>Les deux ont été produits avec les mêmes réglages et sont donc identiques.</translation>
    </message>
</context>
<context>
    <name>texloom::ui::Document</name>
    <message>
        <source>Sessions (*.texloom)</source>
        <translation>Sessions (*.texloom)</translation>
    </message>
    <message>
        <source>&amp;New session</source>
        <translation>&amp;Nouvelle session</translation>
    </message>
    <message>
        <source>Open &amp;session…</source>
        <translation>Ouvrir une &amp;session…</translation>
    </message>
    <message>
        <source>Recent sess&amp;ions</source>
        <translation>Sessions &amp;récentes</translation>
    </message>
    <message>
        <source>S&amp;ave session</source>
        <translation>Enre&amp;gistrer la session</translation>
    </message>
    <message>
        <source>Save session &amp;as…</source>
        <translation>Enregistrer la session &amp;sous…</translation>
    </message>
    <message>
        <source>Save session &amp;with its images…</source>
        <translation>Enregistrer la session a&amp;vec ses images…</translation>
    </message>
    <message>
        <source>No session saved yet</source>
        <translation>Aucune session enregistrée</translation>
    </message>
    <message>
        <source>Open session</source>
        <translation>Ouvrir une session</translation>
    </message>
    <message>
        <source>Opened, but without some files: %1</source>
        <translation>Ouverte, mais sans certains fichiers : %1</translation>
    </message>
    <message>
        <source>Save session</source>
        <translation>Enregistrer la session</translation>
    </message>
    <message>
        <source>Save session with its images</source>
        <translation>Enregistrer la session avec ses images</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1 enregistrée.</translation>
    </message>
    <message>
        <source>The session was not saved. %1</source>
        <translation>La session n’a pas été enregistrée. %1</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Modifications non enregistrées</translation>
    </message>
    <message>
        <source>%1 has changes that are not saved.</source>
        <translation>%1 a des modifications non enregistrées.</translation>
    </message>
    <message>
        <source>The exemplars were edited, and no session holds that yet. Results are kept in any case.</source>
        <translation>Les modèles ont été retouchés et aucune session ne le garde encore. Les résultats sont conservés de toute façon.</translation>
    </message>
    <message>
        <source>Opened, but these files changed since the session was saved, so results will differ: %1.</source>
        <translation>Ouverte, mais ces fichiers ont changé depuis l’enregistrement, et les résultats différeront : %1.</translation>
    </message>
    <message>
        <source>the session</source>
        <translation>la session</translation>
    </message>
</context>
<context>
    <name>texloom::ui::DropTargets</name>
    <message>
        <source>Places to drop</source>
        <translation>Zones de dépôt</translation>
    </message>
    <message>
        <source>Exemplar</source>
        <translation>Échantillon</translation>
    </message>
    <message>
        <source>In place of the one you look at</source>
        <translation>À la place de celui affiché</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Ajouter</translation>
    </message>
    <message>
        <source>Companion map</source>
        <translation>Carte associée</translation>
    </message>
    <message>
        <source>Gets the result&apos;s layout</source>
        <translation>Prend la disposition du résultat</translation>
    </message>
    <message>
        <source>Mask</source>
        <translation>Masque</translation>
    </message>
    <message>
        <source>Black is never copied</source>
        <translation>Le noir n’est jamais copié</translation>
    </message>
    <message>
        <source>The method does not use a mask</source>
        <translation>La méthode n’utilise pas de masque</translation>
    </message>
    <message>
        <source>Mixed with the exemplars in use</source>
        <translation>Mélangé aux échantillons utilisés</translation>
    </message>
    <message>
        <source>Opened to learn from</source>
        <translation>Ouvert pour en apprendre</translation>
    </message>
</context>
<context>
    <name>texloom::ui::ExampleSessions</name>
    <message>
        <source>Exa&amp;mple sessions</source>
        <translation>Sessions d’exe&amp;mple</translation>
    </message>
    <message>
        <source>None were found beside the program</source>
        <translation>Aucun n’a été trouvé auprès du programme</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1 : %2</translation>
    </message>
</context>
<context>
    <name>texloom::ui::ExampleSweeps</name>
    <message>
        <source>Exa&amp;mple sweeps</source>
        <translation>E&amp;xemples de séries</translation>
    </message>
    <message>
        <source>None were found beside the program</source>
        <translation>Aucun n’a été trouvé auprès du programme</translation>
    </message>
</context>
<context>
    <name>texloom::ui::ExemplarEditor</name>
    <message>
        <source>Exemplar being edited</source>
        <translation>Échantillon en retouche</translation>
    </message>
    <message>
        <source>&amp;Done</source>
        <translation>&amp;Terminé</translation>
    </message>
    <message>
        <source>&amp;Look</source>
        <translation>&amp;Voir</translation>
    </message>
    <message>
        <source>Zoom and pan</source>
        <translation>Zoomer et déplacer</translation>
    </message>
    <message>
        <source>&amp;Hide</source>
        <translation>Mas&amp;quer</translation>
    </message>
    <message>
        <source>Paint over what is never copied</source>
        <translation>Peindre ce qui n’est jamais copié</translation>
    </message>
    <message>
        <source>&amp;Unhide</source>
        <translation>Dé&amp;masquer</translation>
    </message>
    <message>
        <source>Paint over what may be copied again</source>
        <translation>Peindre ce qui peut de nouveau être copié</translation>
    </message>
    <message>
        <source>The wheel zooms, dragging moves. Choose a tool above, or turn, mirror and even out the light below. Files stay as they are.</source>
        <translation>La molette zoome, glisser déplace. Choisissez un outil ci-dessus, ou tournez, retournez et égalisez la lumière ci-dessous. Les fichiers restent tels quels.</translation>
    </message>
    <message>
        <source>Hatched = never copied. Shift and the arrow keys move the brush, the space bar dabs.</source>
        <translation>Hachuré = jamais copié. Maj et les flèches déplacent le pinceau, la barre d’espace tamponne.</translation>
    </message>
    <message>
        <source>The method in use does not use a mask.</source>
        <translation>La méthode choisie n’utilise pas de masque.</translation>
    </message>
    <message>
        <source>Clear &amp;mask</source>
        <translation>Effacer le &amp;masque</translation>
    </message>
    <message>
        <source>Edits, in order</source>
        <translation>Retouches, dans l’ordre</translation>
    </message>
    <message>
        <source>&amp;Take back</source>
        <translation>&amp;Annuler la retouche</translation>
    </message>
    <message>
        <source>Takes the chosen edit out; those after it stay where they fit.</source>
        <translation>Retire la retouche choisie ; celles d’après restent là où elles conviennent.</translation>
    </message>
    <message>
        <source>%1 · %2 px</source>
        <translation>%1 · %2 px</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Avant</translation>
    </message>
    <message>
        <source>Take back an edit</source>
        <translation>Annuler une retouche</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Aperçu</translation>
    </message>
    <message>
        <source>%1 (being made)</source>
        <translation>%1 (en cours)</translation>
    </message>
</context>
<context>
    <name>texloom::ui::ExemplarPanel</name>
    <message>
        <source>grey</source>
        <translation>gris</translation>
    </message>
    <message>
        <source>colour</source>
        <translation>couleur</translation>
    </message>
    <message>
        <source>colour and alpha</source>
        <translation>couleur et alpha</translation>
    </message>
    <message>
        <source>%1 channels</source>
        <translation>%1 canaux</translation>
    </message>
    <message>
        <source>%1 px · %2 · %3 · %4</source>
        <translation>%1 px · %2 · %3 · %4</translation>
    </message>
    <message>
        <source>Exemplar</source>
        <translation>Échantillon</translation>
    </message>
    <message>
        <source>No exemplar yet.
Drop a picture here.</source>
        <translation>Pas encore d’échantillon.
Déposez une image ici.</translation>
    </message>
    <message>
        <source>Open exemplars</source>
        <translation>Ouvrir des échantillons</translation>
    </message>
    <message>
        <source>The colour space that the file&apos;s values are in. Data, such as heights, is never converted.</source>
        <translation>L’espace de couleur des valeurs du fichier. Les données, comme les hauteurs, ne sont jamais converties.</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Choisir…</translation>
    </message>
    <message>
        <source>A picture of the exemplar&apos;s size: where it is black, nothing is copied.</source>
        <translation>Une image de la taille de l’échantillon : là où elle est noire, rien n’est copié.</translation>
    </message>
    <message>
        <source>Choose a mask</source>
        <translation>Choisir un masque</translation>
    </message>
    <message>
        <source>Remove the mask</source>
        <translation>Retirer le masque</translation>
    </message>
    <message>
        <source>&amp;Colour space</source>
        <translation>&amp;Espace de couleur</translation>
    </message>
    <message>
        <source>Mask</source>
        <translation>Masque</translation>
    </message>
    <message>
        <source>Maps</source>
        <translation>Cartes</translation>
    </message>
    <message>
        <source>The method does not use a mask.</source>
        <translation>La méthode n’utilise pas de masque.</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Aucun</translation>
    </message>
    <message>
        <source>Position map</source>
        <translation>Carte de positions</translation>
    </message>
    <message>
        <source>Wei&amp;ght</source>
        <translation>Po&amp;ids</translation>
    </message>
    <message>
        <source>%1 (× %2)</source>
        <translation>%1 (× %2)</translation>
    </message>
    <message>
        <source>Painted</source>
        <translation>Peint</translation>
    </message>
    <message>
        <source>How much the exemplar counts beside the others: with 2 as though it were open twice.</source>
        <translation>Combien le modèle compte à côté des autres : avec 2, comme s’il était ouvert deux fois.</translation>
    </message>
    <message>
        <source>The method takes all exemplars alike.</source>
        <translation>La méthode prend tous les modèles de la même façon.</translation>
    </message>
    <message>
        <source>The method learns from one exemplar, the one that is chosen.</source>
        <translation>La méthode apprend d’un seul modèle, celui qui est choisi.</translation>
    </message>
    <message>
        <source>The file holds several pictures; this is the one that is learnt from.</source>
        <translation>Le fichier contient plusieurs images ; c’est de celle-ci que l’on apprend.</translation>
    </message>
    <message>
        <source>&amp;Layer</source>
        <translation>Ca&amp;lque</translation>
    </message>
</context>
<context>
    <name>texloom::ui::ExemplarStore</name>
    <message>
        <source>Colour space</source>
        <translation>Espace de couleur</translation>
    </message>
    <message>
        <source>Mask</source>
        <translation>Masque</translation>
    </message>
    <message>
        <source>Clear mask</source>
        <translation>Effacer le masque</translation>
    </message>
    <message>
        <source>Paint mask</source>
        <translation>Peindre le masque</translation>
    </message>
    <message>
        <source>Erase mask</source>
        <translation>Gommer le masque</translation>
    </message>
    <message>
        <source>Add companion map</source>
        <translation>Ajouter une carte associée</translation>
    </message>
    <message>
        <source>Remove companion map</source>
        <translation>Retirer une carte associée</translation>
    </message>
    <message>
        <source>Kind of companion map</source>
        <translation>Type de carte associée</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Poids</translation>
    </message>
    <message>
        <source>Use exemplar</source>
        <translation>Utiliser l’échantillon</translation>
    </message>
    <message>
        <source>Leave exemplar out</source>
        <translation>Laisser l’échantillon de côté</translation>
    </message>
    <message>
        <source>exemplars</source>
        <translation>échantillons</translation>
    </message>
    <message>
        <source>Layer</source>
        <translation>Calque</translation>
    </message>
</context>
<context>
    <name>texloom::ui::ExportDialog</name>
    <message>
        <source>S&amp;TMap for compositors (EXR)</source>
        <translation>S&amp;TMap pour le compositing (EXR)</translation>
    </message>
    <message>
        <source>Exact &amp;positions (16-bit PNG)</source>
        <translation>&amp;Positions exactes (PNG 16 bits)</translation>
    </message>
    <message>
        <source>&amp;Recipe beside the picture (JSON)</source>
        <translation>&amp;Recette à côté de l’image (JSON)</translation>
    </message>
    <message>
        <source>Companion &amp;maps</source>
        <translation>&amp;Cartes associées</translation>
    </message>
    <message>
        <source>What the files are called, which maps share one, and where green points in normal maps.</source>
        <translation>Comment se nomment les fichiers, quelles cartes en partagent un, et où pointe le vert des normales.</translation>
    </message>
    <message>
        <source>The name of the files. $name is the exemplar&apos;s, $map the kind of map; there is $method, $seed, $w, $h, $size and $place, too.</source>
        <translation>Le nom des fichiers. $name est celui de l’échantillon, $map le type de carte ; il y a aussi $method, $seed, $w, $h, $size et $place.</translation>
    </message>
    <message>
        <source>As the preset says</source>
        <translation>Selon le préréglage</translation>
    </message>
    <message>
        <source>OpenGL, green up</source>
        <translation>OpenGL, vert vers le haut</translation>
    </message>
    <message>
        <source>DirectX, green down</source>
        <translation>DirectX, vert vers le bas</translation>
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
        <translation>Automatique</translation>
    </message>
    <message>
        <source>Automatic: sRGB, or linear for depths that hold it.</source>
        <translation>Automatique : sRGB, ou linéaire pour les profondeurs qui le permettent.</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Choisir…</translation>
    </message>
    <message>
        <source>Choose a folder</source>
        <translation>Choisir un dossier</translation>
    </message>
    <message>
        <source>This method makes new pixels, so there is no map of where they came from.</source>
        <translation>Cette méthode crée des pixels neufs, il n’y a donc pas de carte de leur provenance.</translation>
    </message>
    <message>
        <source>All settings, to make the same result again.</source>
        <translation>Tous les réglages, pour refaire le même résultat.</translation>
    </message>
    <message>
        <source>&amp;Folder</source>
        <translation>&amp;Dossier</translation>
    </message>
    <message>
        <source>&amp;Preset</source>
        <translation>&amp;Préréglage</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Nom</translation>
    </message>
    <message>
        <source>F&amp;ormat</source>
        <translation>F&amp;ormat</translation>
    </message>
    <message>
        <source>&amp;Depth</source>
        <translation>Profonde&amp;ur</translation>
    </message>
    <message>
        <source>&amp;Colour space</source>
        <translation>&amp;Espace de couleur</translation>
    </message>
    <message>
        <source>Norm&amp;als</source>
        <translation>Norm&amp;ales</translation>
    </message>
    <message>
        <source>Position map</source>
        <translation>Carte de positions</translation>
    </message>
    <message>
        <source>Also</source>
        <translation>Aussi</translation>
    </message>
    <message>
        <source>&amp;Write files</source>
        <translation>É&amp;crire les fichiers</translation>
    </message>
    <message>
        <source>The files need a name.</source>
        <translation>Il faut un nom aux fichiers.</translation>
    </message>
    <message>
        <source>The name cannot hold a slash; choose the folder above.</source>
        <translation>Le nom ne peut contenir de barre oblique ; choisissez le dossier ci-dessus.</translation>
    </message>
    <message>
        <source>Choose the folder to write to.</source>
        <translation>Choisissez le dossier de destination.</translation>
    </message>
    <message>
        <source>The folder %1 is not there.</source>
        <translation>Le dossier %1 n’existe pas.</translation>
    </message>
    <message>
        <source>→ %1</source>
        <translation>→ %1</translation>
    </message>
    <message>
        <source>Export to</source>
        <translation>Exporter vers</translation>
    </message>
    <message>
        <source>Folder to write to</source>
        <translation>Dossier où écrire</translation>
    </message>
    <message>
        <source>Export “%1”</source>
        <translation>Exporter « %1 »</translation>
    </message>
    <message>
        <source>Replace &amp;files that Texloom did not write</source>
        <translation>Remplacer les &amp;fichiers que Texloom n&apos;a pas écrits</translation>
    </message>
    <message>
        <source>Written as</source>
        <translation>Écrit en</translation>
    </message>
    <message>
        <source>Raw numbers with JSON</source>
        <translation>Nombres bruts avec JSON</translation>
    </message>
    <message>
        <source>Slices as PNG</source>
        <translation>Coupes en PNG</translation>
    </message>
    <message>
        <source>Slices as TIFF</source>
        <translation>Coupes en TIFF</translation>
    </message>
    <message>
        <source>Slices as OpenEXR</source>
        <translation>Coupes en OpenEXR</translation>
    </message>
    <message>
        <source>%1 voxels are written.</source>
        <translation>%1 voxels sont écrits.</translation>
    </message>
    <message>
        <source>%1 is there, and Texloom did not write it. Choose another name or folder, or allow that it is replaced.</source>
        <translation>%1 existe, et Texloom ne l&apos;a pas écrit. Choisissez un autre nom ou dossier, ou permettez son remplacement.</translation>
    </message>
    <message>
        <source>Create &amp;folder</source>
        <translation>Créer le &amp;dossier</translation>
    </message>
    <message>
        <source>The folder %1 cannot be made.</source>
        <translation>Le dossier %1 ne peut pas être créé.</translation>
    </message>
    <message>
        <source>%1, %2 values clipped</source>
        <translation>%1, %2 valeurs écrêtées</translation>
    </message>
    <message>
        <source>Edit…</source>
        <translation>Modifier…</translation>
    </message>
    <message>
        <source>Make and change presets of your own</source>
        <translation>Créer et modifier ses propres préréglages</translation>
    </message>
    <message>
        <source>Edit export presets</source>
        <translation>Modifier les préréglages d’export</translation>
    </message>
</context>
<context>
    <name>texloom::ui::ExportTable</name>
    <message>
        <source>8-bit</source>
        <translation>8 bits</translation>
    </message>
    <message>
        <source>16-bit</source>
        <translation>16 bits</translation>
    </message>
    <message>
        <source>half</source>
        <translation>demi-précision</translation>
    </message>
    <message>
        <source>float</source>
        <translation>flottant</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <source>Holds</source>
        <translation>Contient</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Profondeur</translation>
    </message>
    <message>
        <source>On disk</source>
        <translation>Sur le disque</translation>
    </message>
    <message>
        <source>Files that will be written</source>
        <translation>Fichiers qui seront écrits</translation>
    </message>
    <message>
        <source>replaces a file that is not Texloom&apos;s</source>
        <translation>remplace un fichier qui n&apos;est pas de Texloom</translation>
    </message>
    <message>
        <source>replaces the file there</source>
        <translation>remplace le fichier existant</translation>
    </message>
    <message>
        <source>new</source>
        <translation>nouveau</translation>
    </message>
    <message>
        <source>Depth of %1</source>
        <translation>Profondeur de %1</translation>
    </message>
</context>
<context>
    <name>texloom::ui::ExtendDialog</name>
    <message>
        <source>Extend the picture</source>
        <translation>Étendre l’image</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>&amp;Gauche</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>&amp;Haut</translation>
    </message>
    <message>
        <source>&amp;Right</source>
        <translation>&amp;Droite</translation>
    </message>
    <message>
        <source>&amp;Bottom</source>
        <translation>&amp;Bas</translation>
    </message>
    <message>
        <source>How far the picture is to reach beyond each of its edges. What lies there is made by the next run.</source>
        <translation>De combien l’image doit dépasser chacun de ses bords. Ce qui s’y trouve est fait par le prochain calcul.</translation>
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
        <translation>%1 px, c’est trop grand ; les côtés vont jusqu’à %2.</translation>
    </message>
</context>
<context>
    <name>texloom::ui::FiguresPanel</name>
    <message>
        <source>exemplar</source>
        <translation>échantillon</translation>
    </message>
    <message>
        <source>result</source>
        <translation>résultat</translation>
    </message>
    <message>
        <source>difference</source>
        <translation>différence</translation>
    </message>
    <message>
        <source>%1: %2 % in other bins</source>
        <translation>%1 : %2 % dans d’autres classes</translation>
    </message>
    <message>
        <source>share, %</source>
        <translation>part, %</translation>
    </message>
    <message>
        <source>Figures</source>
        <translation>Mesures</translation>
    </message>
    <message>
        <source>Make a result to see its figures.</source>
        <translation>Produisez un résultat pour voir ses mesures.</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Image</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>Nombres</translation>
    </message>
    <message>
        <source>Figure</source>
        <translation>Mesure</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valeur</translation>
    </message>
    <message>
        <source>Looking at the result…</source>
        <translation>Examen du résultat…</translation>
    </message>
    <message>
        <source>step</source>
        <translation>étape</translation>
    </message>
    <message>
        <source>Colours: %1</source>
        <translation>Couleurs : %1</translation>
    </message>
    <message>
        <source>value</source>
        <translation>valeur</translation>
    </message>
    <message>
        <source>Patches: first component</source>
        <translation>Patchs : première composante</translation>
    </message>
    <message>
        <source>Patches: second component</source>
        <translation>Patchs : seconde composante</translation>
    </message>
    <message>
        <source>place along the principal axis</source>
        <translation>position sur l’axe principal</translation>
    </message>
    <message>
        <source>Autocorrelation: exemplar</source>
        <translation>Autocorrélation : échantillon</translation>
    </message>
    <message>
        <source>Autocorrelation: result</source>
        <translation>Autocorrélation : résultat</translation>
    </message>
    <message>
        <source>How often pixels are used</source>
        <translation>Fréquence d’emploi des pixels</translation>
    </message>
    <message>
        <source>How often pixels are used: %1</source>
        <translation>Fréquence d’emploi des pixels : %1</translation>
    </message>
    <message>
        <source>Stopped. Make another result, or close and open this dock to start again.</source>
        <translation>Arrêté. Produisez un autre résultat, ou fermez et rouvrez ce volet pour recommencer.</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Genre</translation>
    </message>
    <message>
        <source>Arrays</source>
        <translation>Tableaux</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Valeurs</translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation>Sommets</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Triangles</translation>
    </message>
</context>
<context>
    <name>texloom::ui::FramePage</name>
    <message>
        <source>R&amp;atio</source>
        <translation>R&amp;apport</translation>
    </message>
    <message>
        <source>Draw a rectangle, drag its edges or drag it as a whole; Shift makes a square. N takes the next corner, the arrow keys move it. Enter applies, Esc leaves.</source>
        <translation>Tracez un rectangle, faites glisser ses bords ou le tout ; Maj fait un carré. N prend le coin suivant, les flèches le déplacent. Entrée applique, Échap quitte.</translation>
    </message>
    <message>
        <source>Drag the corners; N takes the next one, the arrow keys move it. Enter applies, Esc leaves.</source>
        <translation>Faites glisser les coins ; N prend le suivant, les flèches le déplacent. Entrée applique, Échap quitte.</translation>
    </message>
    <message>
        <source>The rectangle&apos;s width by its height</source>
        <translation>La largeur du rectangle par sa hauteur</translation>
    </message>
    <message>
        <source>Any</source>
        <translation>Libre</translation>
    </message>
    <message>
        <source>Square</source>
        <translation>Carré</translation>
    </message>
    <message>
        <source>As the picture</source>
        <translation>Comme l’image</translation>
    </message>
</context>
<context>
    <name>texloom::ui::GridRun</name>
    <message>
        <source>Under way…</source>
        <translation>En cours…</translation>
    </message>
    <message>
        <source>Waiting…</source>
        <translation>En attente…</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Annulé.</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>Would take about %1: choose the method and run it by itself.</source>
        <translation>Prendrait environ %1 : choisissez la méthode et lancez-la seule.</translation>
    </message>
</context>
<context>
    <name>texloom::ui::Hovers</name>
    <message>
        <source>%1: x %2, y %3</source>
        <translation>%1 : x %2, y %3</translation>
    </message>
    <message>
        <source>working space · float</source>
        <translation>espace de travail · flottant</translation>
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
        <translation>une fois dans le résultat</translation>
    </message>
    <message>
        <source>%1 times in the result</source>
        <translation>%1 fois dans le résultat</translation>
    </message>
</context>
<context>
    <name>texloom::ui::ImageViewer</name>
    <message>
        <source>%1 pixels at %2. %3</source>
        <translation>%1 pixels à %2. %3</translation>
    </message>
</context>
<context>
    <name>texloom::ui::Inspector</name>
    <message>
        <source>fexsvhidtc</source>
        <translation>fecsvadtgr</translation>
    </message>
</context>
<context>
    <name>texloom::ui::JobPanel</name>
    <message>
        <source>%1, %2 left</source>
        <translation>%1, reste %2</translation>
    </message>
    <message>
        <source>about %1</source>
        <translation>environ %1</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>Failed: %1</source>
        <translation>Échec : %1</translation>
    </message>
    <message>
        <source>waiting</source>
        <translation>en attente</translation>
    </message>
    <message>
        <source>%1 (preview)</source>
        <translation>%1 (aperçu)</translation>
    </message>
    <message>
        <source>Move &amp;up</source>
        <translation>&amp;Monter</translation>
    </message>
    <message>
        <source>Move &amp;down</source>
        <translation>&amp;Descendre</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>A&amp;nnuler</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>&amp;Pause</translation>
    </message>
    <message>
        <source>C&amp;lear</source>
        <translation>&amp;Vider</translation>
    </message>
    <message>
        <source>Runs that wait or are under way</source>
        <translation>Calculs en attente ou en cours</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Calcul</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Progression</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>At &amp;most</source>
        <translation>Au &amp;plus</translation>
    </message>
    <message>
        <source>Most threads that runs may use</source>
        <translation>Nombre maximal de threads des calculs</translation>
    </message>
    <message>
        <source>all threads</source>
        <translation>tous les threads</translation>
    </message>
    <message>
        <source> threads</source>
        <translation> threads</translation>
    </message>
    <message>
        <source>How many of the processor&apos;s threads runs may use from now on. Fewer leave the computer free for other work; the results are the same.</source>
        <translation>Combien de threads du processeur les calculs peuvent utiliser désormais. Moins laisse l’ordinateur libre pour autre chose ; les résultats sont les mêmes.</translation>
    </message>
    <message>
        <source>Move the chosen run forward in the queue</source>
        <translation>Faire plus tôt le calcul choisi</translation>
    </message>
    <message>
        <source>Move the chosen run back in the queue</source>
        <translation>Faire plus tard le calcul choisi</translation>
    </message>
    <message>
        <source>&amp;Stop and keep</source>
        <translation>&amp;Arrêter et garder</translation>
    </message>
    <message>
        <source>End the run under way and keep what is there as a result</source>
        <translation>Terminer le calcul en cours et garder ce qui est là comme résultat</translation>
    </message>
    <message>
        <source>Take the chosen run off the queue; of one under way, nothing is kept</source>
        <translation>Retirer de la file le calcul choisi ; de celui en cours, rien n’est gardé</translation>
    </message>
    <message>
        <source>Start none of the waiting runs; the one under way goes on, and Run still works</source>
        <translation>Ne commencer aucun calcul en attente ; celui en cours continue, et Lancer marche toujours</translation>
    </message>
    <message>
        <source>Take all waiting and failed runs off the queue</source>
        <translation>Retirer de la file tout ce qui attend ou a échoué</translation>
    </message>
    <message>
        <source>Double click or Return on the run under way shows its pictures as they are made</source>
        <translation>Un double-clic ou Entrée sur le calcul en cours le montre tel qu’il avance</translation>
    </message>
    <message>
        <source>No run is waiting. “Add to queue” puts one here, to be made after those before it.</source>
        <translation>Rien n’attend. « Ajouter à la file » met ici un calcul, fait après ceux qui le précèdent.</translation>
    </message>
</context>
<context>
    <name>texloom::ui::LabelPainter</name>
    <message>
        <source>&amp;Fill</source>
        <translation>Re&amp;mplir</translation>
    </message>
    <message>
        <source>Fills the area of one colour that is clicked</source>
        <translation>Remplit la surface d’une couleur sur laquelle on clique</translation>
    </message>
    <message>
        <source>P&amp;ick colour</source>
        <translation>Prélever la coule&amp;ur</translation>
    </message>
    <message>
        <source>Takes the colour that is clicked, and goes back to the brush</source>
        <translation>Prend la couleur sur laquelle on clique, et revient au pinceau</translation>
    </message>
    <message>
        <source>The wheel zooms, the middle button moves the picture. A double click or Enter closes a polygon. Alt and a click takes the colour there, Alt and a number that of the palette; [ and ] make the brush smaller and larger. Without a mouse: Shift and the arrow keys move the cursor, the space bar paints, fills or sets a corner.</source>
        <translation>La molette zoome, le bouton du milieu déplace l’image. Un double clic ou Entrée ferme un polygone. Alt et un clic prend la couleur à cet endroit, Alt et un chiffre celle de la palette ; [ et ] rendent le pinceau plus petit ou plus grand. Sans souris : Maj et les flèches déplacent le curseur, la barre d’espace peint, remplit ou pose un coin.</translation>
    </message>
    <message>
        <source>Colour %1</source>
        <translation>Couleur %1</translation>
    </message>
    <message>
        <source>Colour %1 (Alt+%1)</source>
        <translation>Couleur %1 (Alt+%1)</translation>
    </message>
    <message>
        <source>How much of the picture shows through the colours</source>
        <translation>Quelle part de l’image se voit à travers les couleurs</translation>
    </message>
    <message>
        <source>Picture &amp;shows</source>
        <translation>L’image se &amp;voit</translation>
    </message>
    <message>
        <source>Paint &amp;all</source>
        <translation>&amp;Tout peindre</translation>
    </message>
    <message>
        <source>Paints the whole picture in the colour</source>
        <translation>Peint toute l’image de la couleur</translation>
    </message>
</context>
<context>
    <name>texloom::ui::LatticeFields</name>
    <message>
        <source>First vector</source>
        <translation>Premier vecteur</translation>
    </message>
    <message>
        <source>Second vector</source>
        <translation>Second vecteur</translation>
    </message>
    <message>
        <source>Origin</source>
        <translation>Origine</translation>
    </message>
    <message>
        <source>right, px</source>
        <translation>vers la droite, px</translation>
    </message>
    <message>
        <source>down, px</source>
        <translation>vers le bas, px</translation>
    </message>
    <message>
        <source>%1, right</source>
        <translation>%1, vers la droite</translation>
    </message>
    <message>
        <source>%1, down</source>
        <translation>%1, vers le bas</translation>
    </message>
    <message>
        <source>Where a tile begins. The methods choose by themselves until it is moved.</source>
        <translation>Où commence une tuile. Les méthodes choisissent elles-mêmes tant qu’on ne la déplace pas.</translation>
    </message>
</context>
<context>
    <name>texloom::ui::LatticeSearchForm</name>
    <message>
        <source>Advanced</source>
        <translation>Avancé</translation>
    </message>
    <message>
        <source>What decides between lattices when one is looked for</source>
        <translation>Ce qui départage les réseaux lors de la recherche</translation>
    </message>
</context>
<context>
    <name>texloom::ui::LatticeTool</name>
    <message>
        <source>Exemplar with its lattice</source>
        <translation>Échantillon avec son réseau</translation>
    </message>
    <message>
        <source>Open an exemplar to find its lattice.</source>
        <translation>Ouvrez un échantillon pour trouver son réseau.</translation>
    </message>
    <message>
        <source>Correlation of the exemplar with itself</source>
        <translation>Corrélation de l’échantillon avec lui-même</translation>
    </message>
    <message>
        <source>How alike the exemplar is to itself when it is moved: bright where it repeats. The lattice&apos;s points belong on the bright spots.</source>
        <translation>À quel point l’échantillon décalé se ressemble : clair là où il se répète. Les points du réseau vont sur les taches claires.</translation>
    </message>
    <message>
        <source>The correlation of the exemplar with itself shows here.</source>
        <translation>La corrélation de l’échantillon avec lui-même s’affiche ici.</translation>
    </message>
    <message>
        <source>Detect</source>
        <translation>Détecter</translation>
    </message>
    <message>
        <source>Look for the lattice in the exemplar again</source>
        <translation>Chercher de nouveau le réseau dans l’échantillon</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Ajuster</translation>
    </message>
    <message>
        <source>Move the vectors so that all their multiples come nearest to the bright spots</source>
        <translation>Déplacer les vecteurs pour que tous leurs multiples s’approchent au mieux des taches claires</translation>
    </message>
    <message>
        <source>Looking for the lattice…</source>
        <translation>Recherche du réseau…</translation>
    </message>
    <message>
        <source>Use in %1</source>
        <translation>Utiliser dans %1</translation>
    </message>
    <message>
        <source>%1 follows no lattice.</source>
        <translation>%1 ne suit aucun réseau.</translation>
    </message>
    <message>
        <source>%1 is set to use no lattice.</source>
        <translation>%1 est réglé sans réseau.</translation>
    </message>
    <message>
        <source>%1 looks for the lattice by itself.</source>
        <translation>%1 cherche lui-même le réseau.</translation>
    </message>
    <message>
        <source>✓ %1 uses this lattice.</source>
        <translation>✓ %1 utilise ce réseau.</translation>
    </message>
    <message>
        <source>%1 uses another lattice: %2 and %3 px.</source>
        <translation>%1 utilise un autre réseau : %2 et %3 px.</translation>
    </message>
    <message>
        <source>Open an exemplar first.</source>
        <translation>Ouvrez d’abord un échantillon.</translation>
    </message>
    <message>
        <source>Press Detect to look for the lattice, or give its vectors.</source>
        <translation>Cliquez sur Détecter pour chercher le réseau, ou donnez ses vecteurs.</translation>
    </message>
    <message>
        <source>%1 repeats itself by this lattice (confidence %2).</source>
        <translation>%1 se répète selon ce réseau (confiance %2).</translation>
    </message>
    <message>
        <source> The exemplar holds fewer than two of these tiles on a side, so results repeat much of it.</source>
        <translation> L’échantillon contient moins de deux de ces tuiles par côté, les résultats en répètent donc beaucoup.</translation>
    </message>
    <message>
        <source>%1 repeats itself in rows (confidence %2); what lies along them may come from anywhere in a row.</source>
        <translation>%1 se répète par rangées (confiance %2) ; ce qu’elles contiennent peut venir de n’importe où dans une rangée.</translation>
    </message>
    <message>
        <source>Nothing in %1 repeats itself, but rows run through all of it (confidence %2): they keep their order, and begin again after %3 px. If you see it repeat, rectify the exemplar first (Ctrl+D) where it is seen at an angle, or drag the vectors.</source>
        <translation>Rien dans %1 ne se répète, mais des rangées la traversent entièrement (confiance %2) : elles gardent leur ordre et recommencent après %3 px. Si vous la voyez se répéter, redressez d’abord l’échantillon (Ctrl+D) s’il est vu de biais, ou glissez les vecteurs.</translation>
    </message>
    <message>
        <source>Nothing in %1 repeats itself. A vector must fit into the exemplar about twice to be found. If you see it repeat, give the vectors, or rectify the exemplar first (Ctrl+D) where it is seen at an angle; if not, methods without a lattice suit it, such as image quilting.</source>
        <translation>Rien ne se répète dans %1. Un vecteur doit tenir environ deux fois dans l’échantillon pour être trouvé. Si vous voyez une répétition, donnez les vecteurs, ou redressez d’abord l’échantillon (Ctrl+D) s’il est vu de biais ; sinon, les méthodes sans réseau conviennent, comme le quilting d’images.</translation>
    </message>
    <message>
        <source>No lattice stands out in %1 (confidence %2). Choose one below, drag the vectors to what you see, or rectify the exemplar first (Ctrl+D) where it is seen at an angle; if it does not repeat, methods without a lattice suit it, such as image quilting.</source>
        <translation>Aucun réseau ne ressort dans %1 (confiance %2). Choisissez-en un ci-dessous, glissez les vecteurs sur ce que vous voyez, ou redressez d’abord l’échantillon (Ctrl+D) s’il est vu de biais ; s’il ne se répète pas, les méthodes sans réseau conviennent, comme le quilting d’images.</translation>
    </message>
    <message>
        <source>Set by hand: %1 agrees with itself by %2 at the multiples of these vectors; by %3 at those of the best that was found.</source>
        <translation>Placé à la main : %1 concorde avec elle-même à %2 aux multiples de ces vecteurs ; à %3 à ceux du meilleur trouvé.</translation>
    </message>
</context>
<context>
    <name>texloom::ui::LayerDialog</name>
    <message>
        <source>Page %1</source>
        <translation>Page %1</translation>
    </message>
    <message>
        <source>Part %1</source>
        <translation>Partie %1</translation>
    </message>
    <message>
        <source>All channels</source>
        <translation>Tous les canaux</translation>
    </message>
    <message>
        <source>Choose a layer</source>
        <translation>Choisir un calque</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Calques</translation>
    </message>
    <message>
        <source>%1 holds several pictures. Which one is to be taken?</source>
        <translation>%1 contient plusieurs images. Laquelle faut-il prendre ?</translation>
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
        <translation>Les derniers résultats restent en mémoire jusqu’à cette limite ; les autres sont lus du disque quand on les montre.</translation>
    </message>
    <message>
        <source>Beyond this the oldest results are removed; those pinned stay.</source>
        <translation>Au-delà, les plus anciens résultats sont retirés ; ceux épinglés restent.</translation>
    </message>
    <message>
        <source>Limits for results</source>
        <translation>Limites des résultats</translation>
    </message>
    <message>
        <source>In &amp;memory</source>
        <translation>En &amp;mémoire</translation>
    </message>
    <message>
        <source>On the &amp;disk</source>
        <translation>Sur le &amp;disque</translation>
    </message>
    <message>
        <source>Kept in</source>
        <translation>Gardés dans</translation>
    </message>
    <message>
        <source> GiB</source>
        <translation> Gio</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Actuellement</translation>
    </message>
    <message>
        <source>%1 in memory, %2 on the disk</source>
        <translation>%1 en mémoire, %2 sur le disque</translation>
    </message>
    <message>
        <source>&amp;Show the folder</source>
        <translation>&amp;Montrer le dossier</translation>
    </message>
</context>
<context>
    <name>texloom::ui::LogPanel</name>
    <message>
        <source>Log</source>
        <translation>Journal</translation>
    </message>
    <message>
        <source>What is run, and what goes wrong, is noted here.</source>
        <translation>Ce qui est calculé, et ce qui échoue, est noté ici.</translation>
    </message>
    <message>
        <source>Copy all</source>
        <translation>Tout copier</translation>
    </message>
    <message>
        <source>Copy the whole log, for a report</source>
        <translation>Copier tout le journal, pour un rapport</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Vider</translation>
    </message>
    <message>
        <source>Take all lines off the log</source>
        <translation>Retirer toutes les lignes du journal</translation>
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
        <translation>Méthode</translation>
    </message>
    <message>
        <source>Exemplars</source>
        <translation>Échantillons</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Paramètres</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Fichier</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>Ouverts &amp;récemment</translation>
    </message>
    <message>
        <source>&amp;Samples</source>
        <translation>&amp;Exemples</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Édition</translation>
    </message>
    <message>
        <source>E&amp;xemplar</source>
        <translation>É&amp;chantillon</translation>
    </message>
    <message>
        <source>&amp;Synthesis</source>
        <translation>&amp;Synthèse</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>A&amp;ide</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>Affic&amp;hage</translation>
    </message>
    <message>
        <source>&amp;Appearance</source>
        <translation>&amp;Apparence</translation>
    </message>
    <message>
        <source>As the &amp;desktop</source>
        <translation>Comme le &amp;bureau</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Clair</translation>
    </message>
    <message>
        <source>Da&amp;rk</source>
        <translation>&amp;Sombre</translation>
    </message>
    <message>
        <source>Toolbar</source>
        <translation>Barre d’outils</translation>
    </message>
    <message>
        <source>%1 holds the settings of a result.</source>
        <translation>%1 contient les réglages d’un résultat.</translation>
    </message>
    <message>
        <source>Open exemplars</source>
        <translation>Ouvrir des échantillons</translation>
    </message>
    <message>
        <source>Nothing opened yet</source>
        <translation>Rien d’ouvert encore</translation>
    </message>
    <message>
        <source>Only files on this computer can be opened; save the picture first, then drop its file.</source>
        <translation>Seuls les fichiers de cet ordinateur peuvent être ouverts ; enregistrez d’abord l’image, puis déposez son fichier.</translation>
    </message>
    <message>
        <source>There is no picture in what was pasted; copy a picture or a picture file first.</source>
        <translation>Il n’y a pas d’image dans ce qui a été collé ; copiez d’abord une image ou un fichier image.</translation>
    </message>
    <message>
        <source>Let go to open it as an exemplar.</source>
        <translation>Lâchez pour l’ouvrir comme échantillon.</translation>
    </message>
    <message>
        <source>%1 was made here and holds its settings.</source>
        <translation>%1 a été produit ici et contient ses réglages.</translation>
    </message>
    <message>
        <source>Restore settings</source>
        <translation>Rétablir les réglages</translation>
    </message>
    <message>
        <source>Settings restored, but these files changed since, so the result will differ: %1.</source>
        <translation>Réglages rétablis, mais ces fichiers ont changé depuis, le résultat différera donc : %1.</translation>
    </message>
    <message>
        <source>About Texloom</source>
        <translation>À propos de Texloom</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Texloom %1&lt;/h3&gt;&lt;p&gt;A workbench for exemplar-based texture synthesis.&lt;/p&gt;&lt;p&gt;Free software under the GNU General Public License, version 3 or later.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Texloom %1&lt;/h3&gt;&lt;p&gt;Un atelier de synthèse de textures par l’échantillon.&lt;/p&gt;&lt;p&gt;Logiciel libre sous licence publique générale GNU, version 3 ou ultérieure.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Reading the picture…</source>
        <translation>Lecture de l’image…</translation>
    </message>
    <message>
        <source>Open an exemplar first.</source>
        <translation>Ouvrez d’abord un échantillon.</translation>
    </message>
    <message>
        <source>%1[*] – Texloom</source>
        <translation>%1[*] – Texloom</translation>
    </message>
    <message>
        <source>Lattice</source>
        <translation>Réseau</translation>
    </message>
    <message>
        <source>The vectors by which the exemplar repeats itself: found, corrected, and given to the method.</source>
        <translation>Les vecteurs selon lesquels l’échantillon se répète : trouvés, corrigés et donnés à la méthode.</translation>
    </message>
    <message>
        <source>Figures</source>
        <translation>Mesures</translation>
    </message>
    <message>
        <source>&amp;Tools</source>
        <translation>&amp;Outils</translation>
    </message>
    <message>
        <source>Result: %1</source>
        <translation>Résultat : %1</translation>
    </message>
    <message>
        <source>Open an exemplar first: its patches are compared with each other.</source>
        <translation>Ouvrez d’abord un échantillon : ses patchs sont comparés entre eux.</translation>
    </message>
    <message>
        <source>Earlier: %1</source>
        <translation>Auparavant : %1</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Comparaison</translation>
    </message>
    <message>
        <source>Several results and exemplars beside one another.</source>
        <translation>Plusieurs résultats et échantillons côte à côte.</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>Résultats</translation>
    </message>
    <message>
        <source>Jobs</source>
        <translation>Calculs</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Journal</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>The recipe was made by Texloom %1; this is %2, so the result may differ.</source>
        <translation>La recette a été faite par Texloom %1 ; ceci est %2, le résultat peut donc différer.</translation>
    </message>
    <message>
        <source>Stopped. One run that waited was given up.</source>
        <translation>Arrêté. Un calcul en attente a été abandonné.</translation>
    </message>
    <message>
        <source>Stopped. %1 runs that waited were given up.</source>
        <translation>Arrêté. %1 calculs en attente ont été abandonnés.</translation>
    </message>
    <message>
        <source>Maps of the same material lie beside it: %1.</source>
        <translation>Des cartes du même matériau se trouvent à côté : %1.</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Ajouter</translation>
    </message>
    <message>
        <source>There is a preset %1 already.</source>
        <translation>Il y a déjà un préréglage %1.</translation>
    </message>
    <message>
        <source>Replace it</source>
        <translation>Le remplacer</translation>
    </message>
    <message>
        <source>The session was saved by Texloom %1; this is %2, so results may differ.</source>
        <translation>La session a été enregistrée par Texloom %1 ; ceci est %2, les résultats peuvent donc différer.</translation>
    </message>
    <message>
        <source>S&amp;olids</source>
        <translation>S&amp;olides</translation>
    </message>
    <message>
        <source>A generator that was trained already: look at it in the Volume tab.</source>
        <translation>Un générateur déjà entraîné : à voir dans l’onglet Volume.</translation>
    </message>
    <message>
        <source>&amp;Open a solid…</source>
        <translation>&amp;Ouvrir un solide…</translation>
    </message>
    <message>
        <source>Solid to look at</source>
        <translation>Solide à regarder</translation>
    </message>
    <message>
        <source>Generators and volumes (*.safetensors *.json);;Slices of a volume (*.png *.tif *.exr)</source>
        <translation>Générateurs et volumes (*.safetensors *.json);;Coupes d’un volume (*.png *.tif *.exr)</translation>
    </message>
</context>
<context>
    <name>texloom::ui::MapDeriver</name>
    <message>
        <source>Deri&amp;ve a map</source>
        <translation>Déri&amp;ver une carte</translation>
    </message>
    <message>
        <source>&amp;Normal from height</source>
        <translation>&amp;Normales d’après la hauteur</translation>
    </message>
    <message>
        <source>Makes the normal map that belongs to the height map.</source>
        <translation>Fait la carte de normales qui correspond à la carte de hauteur.</translation>
    </message>
    <message>
        <source>&amp;Height from normal</source>
        <translation>&amp;Hauteur d’après les normales</translation>
    </message>
    <message>
        <source>Integrates the slopes of the normal map; how deep the relief is cannot be told from it.</source>
        <translation>Intègre les pentes de la carte de normales ; elle ne dit pas la profondeur du relief.</translation>
    </message>
    <message>
        <source>&amp;Roughness, a first guess</source>
        <translation>&amp;Rugosité, une première estimation</translation>
    </message>
    <message>
        <source>Bright and pale places are taken as smooth, dark ones as rough: a start, to be corrected by hand.</source>
        <translation>Les endroits clairs et pâles sont pris comme lisses, les sombres comme rugueux : un début, à corriger à la main.</translation>
    </message>
    <message>
        <source>&amp;Occlusion, a first guess</source>
        <translation>&amp;Occlusion, une première estimation</translation>
    </message>
    <message>
        <source>Places that lie below their surroundings in the height map are darkened.</source>
        <translation>Les endroits plus bas que leur entourage dans la carte de hauteur sont assombris.</translation>
    </message>
</context>
<context>
    <name>texloom::ui::MapPage</name>
    <message>
        <source>Estimate the map</source>
        <translation>Estimer la carte</translation>
    </message>
    <message>
        <source>Look for the place in the exemplar that each pixel of the result is most like</source>
        <translation>Chercher l’endroit de l’échantillon auquel chaque pixel du résultat ressemble le plus</translation>
    </message>
    <message>
        <source>Estimating the map…</source>
        <translation>Estimation de la carte…</translation>
    </message>
</context>
<context>
    <name>texloom::ui::MaskPainter</name>
    <message>
        <source>&amp;Take away</source>
        <translation>&amp;Retirer</translation>
    </message>
    <message>
        <source>The wheel zooms, the middle button moves the picture. A double click or Enter closes a polygon. Alt takes away; [ and ] make the brush smaller and larger. Without a mouse: Shift and the arrow keys move the cursor, the space bar paints or sets a corner.</source>
        <translation>La molette zoome, le bouton du milieu déplace l’image. Un double clic ou Entrée ferme un polygone. Alt retire ; [ et ] rendent le pinceau plus petit ou plus grand. Sans souris : Maj et les flèches déplacent le curseur, la barre d’espace peint ou pose un coin.</translation>
    </message>
    <message>
        <source>Shapes are taken away from what is painted. Alt does the same for one shape.</source>
        <translation>Les formes sont retirées de ce qui est peint. Alt fait de même pour une forme.</translation>
    </message>
    <message>
        <source>Painted: black in the mask, lighter where it is softened.</source>
        <translation>Peint : noir dans le masque, plus clair là où c’est adouci.</translation>
    </message>
    <message>
        <source>Pixels by which edges are moved</source>
        <translation>Pixels dont les bords sont déplacés</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>By how many pixels the buttons below grow, shrink or soften what is painted.</source>
        <translation>De combien de pixels les boutons ci-dessous étendent, réduisent ou adoucissent ce qui est peint.</translation>
    </message>
    <message>
        <source>Edges by</source>
        <translation>Bords de</translation>
    </message>
    <message>
        <source>&amp;Grow</source>
        <translation>É&amp;tendre</translation>
    </message>
    <message>
        <source>Paints further, by so many pixels</source>
        <translation>Peint plus loin, d’autant de pixels</translation>
    </message>
    <message>
        <source>&amp;Shrink</source>
        <translation>Ré&amp;duire</translation>
    </message>
    <message>
        <source>Paints less far, by so many pixels</source>
        <translation>Peint moins loin, d’autant de pixels</translation>
    </message>
    <message>
        <source>&amp;Feather</source>
        <translation>Adouc&amp;ir</translation>
    </message>
    <message>
        <source>Softens the edge outwards, over so many pixels: what was painted stays whole</source>
        <translation>Adoucit le bord vers l’extérieur, sur autant de pixels : ce qui était peint reste entier</translation>
    </message>
    <message>
        <source>&amp;Invert</source>
        <translation>In&amp;verser</translation>
    </message>
    <message>
        <source>Paints what is not painted, and nothing else</source>
        <translation>Peint ce qui n’est pas peint, et rien d’autre</translation>
    </message>
    <message>
        <source>Cl&amp;ear</source>
        <translation>&amp;Effacer</translation>
    </message>
    <message>
        <source>Takes all away that is painted</source>
        <translation>Retire tout ce qui est peint</translation>
    </message>
</context>
<context>
    <name>texloom::ui::MaterialPage</name>
    <message>
        <source>Drag to turn it, with the middle button to move it, with Shift and the right button to turn the light; the wheel comes nearer. C shows the maps alone, M the material, F frames it, R resets.</source>
        <translation>Glissez pour le tourner, avec le bouton du milieu pour le déplacer, avec Maj et le bouton droit pour tourner la lumière ; la molette rapproche. C montre les cartes seules, M le matériau, F le cadre, R réinitialise.</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>Sphère</translation>
    </message>
    <message>
        <source>Cube</source>
        <translation>Cube</translation>
    </message>
    <message>
        <source>Cylinder</source>
        <translation>Cylindre</translation>
    </message>
    <message>
        <source>Mesh from a file…</source>
        <translation>Maillage d’un fichier…</translation>
    </message>
    <message>
        <source>Studio lights</source>
        <translation>Lumières de studio</translation>
    </message>
    <message>
        <source>Courtyard</source>
        <translation>Cour</translation>
    </message>
    <message>
        <source>Studio room</source>
        <translation>Salle de studio</translation>
    </message>
    <message>
        <source>Sunset</source>
        <translation>Coucher de soleil</translation>
    </message>
    <message>
        <source>Panorama from a file…</source>
        <translation>Panorama d’un fichier…</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Matériau</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Couleur</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>Normales</translation>
    </message>
    <message>
        <source>Roughness</source>
        <translation>Rugosité</translation>
    </message>
    <message>
        <source>Metallic</source>
        <translation>Métallique</translation>
    </message>
    <message>
        <source>Occlusion</source>
        <translation>Occlusion</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Hauteur</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Opacité</translation>
    </message>
    <message>
        <source>Grey</source>
        <translation>Gris</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Lumière</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Aucun</translation>
    </message>
    <message>
        <source>From the lowest height to the highest, as a share of the maps&apos; side; needs a height map</source>
        <translation>De la plus petite hauteur à la plus grande, en part du côté des cartes ; demande une carte de hauteurs</translation>
    </message>
    <message>
        <source> stops</source>
        <translation> crans</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Forme</translation>
    </message>
    <message>
        <source>Repeat</source>
        <translation>Répéter</translation>
    </message>
    <message>
        <source>Relief</source>
        <translation>Relief</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Montrer</translation>
    </message>
    <message>
        <source>Lit by</source>
        <translation>Éclairé par</translation>
    </message>
    <message>
        <source>Turned by</source>
        <translation>Tourné de</translation>
    </message>
    <message>
        <source>Exposure</source>
        <translation>Exposition</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Arrière-plan</translation>
    </message>
    <message>
        <source>Save picture…</source>
        <translation>Enregistrer l’image…</translation>
    </message>
    <message>
        <source>Turntable…</source>
        <translation>Tour complet…</translation>
    </message>
    <message>
        <source>Mesh to show the material on</source>
        <translation>Maillage qui porte le matériau</translation>
    </message>
    <message>
        <source>Meshes (*.obj *.ply *.gltf *.glb)</source>
        <translation>Maillages (*.obj *.ply *.gltf *.glb)</translation>
    </message>
    <message>
        <source>Panorama to light the material by</source>
        <translation>Panorama qui éclaire le matériau</translation>
    </message>
    <message>
        <source>Pictures (*.exr *.hdr *.tif *.png *.jpg)</source>
        <translation>Images (*.exr *.hdr *.tif *.png *.jpg)</translation>
    </message>
    <message>
        <source>Save the picture of the material</source>
        <translation>Enregistrer l’image du matériau</translation>
    </message>
    <message>
        <source>Pictures (*.png *.exr *.tif *.jpg)</source>
        <translation>Images (*.png *.exr *.tif *.jpg)</translation>
    </message>
    <message>
        <source>Folder for the pictures of a turn</source>
        <translation>Dossier des images d’un tour</translation>
    </message>
    <message>
        <source>There is no material to save a picture of yet; press Run first.</source>
        <translation>Il n’y a pas encore de matériau à enregistrer ; appuyez d’abord sur Lancer.</translation>
    </message>
    <message>
        <source>Writing %1 pictures of a turn</source>
        <translation>Écriture de %1 images d’un tour</translation>
    </message>
</context>
<context>
    <name>texloom::ui::MaterialView</name>
    <message>
        <source>Material</source>
        <translation>Matériau</translation>
    </message>
    <message>
        <source>Drawing…</source>
        <translation>Dessin en cours…</translation>
    </message>
    <message>
        <source>No result yet. Press Run.</source>
        <translation>Pas encore de résultat. Cliquez sur Lancer.</translation>
    </message>
</context>
<context>
    <name>texloom::ui::MessageBar</name>
    <message>
        <source>Close message</source>
        <translation>Fermer le message</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Erreur</translation>
    </message>
    <message>
        <source>Information</source>
        <translation>Information</translation>
    </message>
</context>
<context>
    <name>texloom::ui::MethodForm</name>
    <message>
        <source>Only used while “%1” is %2.</source>
        <translation>Utilisé seulement si « %1 » est %2.</translation>
    </message>
</context>
<context>
    <name>texloom::ui::MethodHint</name>
    <message>
        <source>Methods that suit the exemplar</source>
        <translation>Méthodes qui conviennent à l&apos;échantillon</translation>
    </message>
    <message>
        <source>Try first: %1. %2</source>
        <translation>À essayer d&apos;abord : %1. %2</translation>
    </message>
</context>
<context>
    <name>texloom::ui::MethodsDialog</name>
    <message>
        <source>At a &amp;preview&apos;s size, not at %1 px</source>
        <translation>À la taille d’un &amp;aperçu, non de %1 px</translation>
    </message>
    <message>
        <source>Try some methods</source>
        <translation>Essayer quelques méthodes</translation>
    </message>
    <message>
        <source>Methods to try</source>
        <translation>Méthodes à essayer</translation>
    </message>
    <message>
        <source>Makes a run with each method ticked and shows them side by side.</source>
        <translation>Fait un calcul avec chaque méthode cochée et les montre côte à côte.</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Démarrer</translation>
    </message>
</context>
<context>
    <name>texloom::ui::MissingFilesDialog</name>
    <message>
        <source>&amp;Find…</source>
        <translation>&amp;Chercher…</translation>
    </message>
    <message>
        <source>Missing files</source>
        <translation>Fichiers manquants</translation>
    </message>
    <message>
        <source>Says where the chosen file is now; others that lie beside it are found with it.</source>
        <translation>Indique où est maintenant le fichier choisi ; les autres qui sont à côté sont trouvés avec lui.</translation>
    </message>
    <message>
        <source>Where is %1?</source>
        <translation>Où est %1 ?</translation>
    </message>
    <message>
        <source>%1 (%1);;All files (*)</source>
        <translation>%1 (%1);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>All files were found.</source>
        <translation>Tous les fichiers ont été trouvés.</translation>
    </message>
    <message>
        <source>These files of the session are not where they were. Say where they are, or go on without them; everything else is kept.</source>
        <translation>Ces fichiers de la session ne sont plus où ils étaient. Indiquez où ils sont, ou continuez sans eux ; tout le reste est gardé.</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>&amp;Ouvrir</translation>
    </message>
    <message>
        <source>&amp;Go on without them</source>
        <translation>Continuer &amp;sans eux</translation>
    </message>
</context>
<context>
    <name>texloom::ui::Navigator</name>
    <message>
        <source>The whole picture. Drag the frame to look elsewhere; N shows and hides this.</source>
        <translation>Toute l&apos;image. Déplacez le cadre pour regarder ailleurs ; N la montre et la cache.</translation>
    </message>
</context>
<context>
    <name>texloom::ui::NumbersEditor</name>
    <message>
        <source>%1, across</source>
        <translation>%1, horizontal</translation>
    </message>
    <message>
        <source>%1, down</source>
        <translation>%1, vertical</translation>
    </message>
    <message>
        <source>auto</source>
        <translation>auto</translation>
    </message>
    <message>
        <source>Left, top</source>
        <translation>Gauche, haut</translation>
    </message>
    <message>
        <source>Width, height</source>
        <translation>Largeur, hauteur</translation>
    </message>
    <message>
        <source>Point %1</source>
        <translation>Point %1</translation>
    </message>
</context>
<context>
    <name>texloom::ui::OutputGroup</name>
    <message>
        <source>Output</source>
        <translation>Sortie</translation>
    </message>
    <message>
        <source>across (X)</source>
        <translation>en travers (X)</translation>
    </message>
    <message>
        <source>down (Y)</source>
        <translation>en hauteur (Y)</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Largeur</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Hauteur</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatique</translation>
    </message>
    <message>
        <source>&lt;b&gt;Threads&lt;/b&gt; How many of the processor&apos;s cores a run uses. The result is the same with any number. Automatic: one for each core.</source>
        <translation>&lt;b&gt;Threads&lt;/b&gt; Combien de cœurs du processeur un calcul utilise. Le résultat est le même quel que soit le nombre. Automatique : un par cœur.</translation>
    </message>
    <message>
        <source>S&amp;ize</source>
        <translation>Ta&amp;ille</translation>
    </message>
    <message>
        <source>Wraps</source>
        <translation>Raccord</translation>
    </message>
    <message>
        <source>See&amp;d</source>
        <translation>&amp;Graine</translation>
    </message>
    <message>
        <source>&amp;Threads</source>
        <translation>&amp;Threads</translation>
    </message>
    <message>
        <source>&lt;b&gt;Size&lt;/b&gt; Width and height of the result in pixels, 1 to %1 each.</source>
        <translation>&lt;b&gt;Taille&lt;/b&gt; Largeur et hauteur du résultat en pixels, de 1 à %1 chacune.</translation>
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
        <translation>%1 fois la taille de l’échantillon</translation>
    </message>
    <message>
        <source>&lt;b&gt;×%1&lt;/b&gt; Makes the result %1 times as wide and as high as the exemplar.</source>
        <translation>&lt;b&gt;×%1&lt;/b&gt; Rend le résultat %1 fois aussi large et haut que l’échantillon.</translation>
    </message>
    <message>
        <source>of the exemplar</source>
        <translation>de l’échantillon</translation>
    </message>
    <message>
        <source>Wraps across</source>
        <translation>Raccord en travers</translation>
    </message>
    <message>
        <source>Wraps down</source>
        <translation>Raccord en hauteur</translation>
    </message>
    <message>
        <source>&lt;b&gt;Seed&lt;/b&gt; Where the random choices begin. The same seed and settings give the same pixels.</source>
        <translation>&lt;b&gt;Graine&lt;/b&gt; Où commencent les choix aléatoires. Mêmes graine et réglages, mêmes pixels.</translation>
    </message>
    <message>
        <source>Draw a new seed</source>
        <translation>Tirer une nouvelle graine</translation>
    </message>
    <message>
        <source>Keep the seed</source>
        <translation>Garder la graine</translation>
    </message>
    <message>
        <source>&lt;b&gt;Keep the seed&lt;/b&gt; On: every run uses this seed. Off: every run draws a new one.</source>
        <translation>&lt;b&gt;Garder la graine&lt;/b&gt; Activé : chaque calcul utilise cette graine. Désactivé : chacun en tire une nouvelle.</translation>
    </message>
    <message>
        <source>left and right edges</source>
        <translation>bords gauche et droit</translation>
    </message>
    <message>
        <source>upper and lower edges</source>
        <translation>bords haut et bas</translation>
    </message>
    <message>
        <source>&lt;b&gt;Wraps&lt;/b&gt; The result&apos;s %1 join without a seam when it is repeated.</source>
        <translation>&lt;b&gt;Raccord&lt;/b&gt; Les %1 du résultat se joignent sans couture quand on le répète.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Wraps&lt;/b&gt; %1 cannot make a result that wraps.</source>
        <translation>&lt;b&gt;Raccord&lt;/b&gt; %1 ne peut pas produire de résultat qui se raccorde.</translation>
    </message>
    <message>
        <source>Make</source>
        <translation>Produire</translation>
    </message>
    <message>
        <source>&lt;b&gt;Only a part&lt;/b&gt; Makes a rectangle of the output, which equals that part of the whole.</source>
        <translation>&lt;b&gt;Une partie seulement&lt;/b&gt; Produit un rectangle de la sortie, égal à cette partie du tout.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Only a part&lt;/b&gt; %1 can only make the whole.</source>
        <translation>&lt;b&gt;Une partie seulement&lt;/b&gt; %1 ne peut produire que le tout.</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Graine</translation>
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
        <translation>Image sur laquelle on peint</translation>
    </message>
    <message>
        <source>&amp;Brush</source>
        <translation>&amp;Pinceau</translation>
    </message>
    <message>
        <source>Paints where the mouse drags</source>
        <translation>Peint là où la souris glisse</translation>
    </message>
    <message>
        <source>&amp;Lasso</source>
        <translation>&amp;Lasso</translation>
    </message>
    <message>
        <source>Takes what the mouse drags around</source>
        <translation>Prend ce que la souris entoure</translation>
    </message>
    <message>
        <source>&amp;Polygon</source>
        <translation>Pol&amp;ygone</translation>
    </message>
    <message>
        <source>Gets a corner at each click</source>
        <translation>Reçoit un coin à chaque clic</translation>
    </message>
    <message>
        <source>&amp;Rectangle</source>
        <translation>Re&amp;ctangle</translation>
    </message>
    <message>
        <source>Goes from corner to corner</source>
        <translation>Va d’un coin à l’autre</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>Lar&amp;geur</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>A&amp;nnuler</translation>
    </message>
    <message>
        <source>Goes back by a step (Ctrl+Z)</source>
        <translation>Revient d’un pas en arrière (Ctrl+Z)</translation>
    </message>
    <message>
        <source>Re&amp;do</source>
        <translation>Réta&amp;blir</translation>
    </message>
    <message>
        <source>Makes an undone step again (Ctrl+Shift+Z)</source>
        <translation>Refait un pas annulé (Ctrl+Maj+Z)</translation>
    </message>
    <message>
        <source>Painted and not kept</source>
        <translation>Peint et pas gardé</translation>
    </message>
    <message>
        <source>What you painted is lost unless you keep it.</source>
        <translation>Ce que vous avez peint est perdu si vous ne le gardez pas.</translation>
    </message>
    <message>
        <source>&amp;Keep</source>
        <translation>&amp;Garder</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Abandonner</translation>
    </message>
    <message>
        <source>&amp;Go on painting</source>
        <translation>&amp;Continuer à peindre</translation>
    </message>
</context>
<context>
    <name>texloom::ui::ParamRow</name>
    <message>
        <source>on</source>
        <translation>activé</translation>
    </message>
    <message>
        <source>off</source>
        <translation>désactivé</translation>
    </message>
    <message>
        <source>Reset “%1” to its default</source>
        <translation>Rétablir la valeur par défaut de « %1 »</translation>
    </message>
    <message>
        <source>Default: %1.</source>
        <translation>Par défaut : %1.</translation>
    </message>
    <message>
        <source>Default: %1 % of the exemplar&apos;s shorter side.</source>
        <translation>Par défaut : %1 % du petit côté de l’échantillon.</translation>
    </message>
    <message>
        <source>Default: %1 % of the exemplar&apos;s shorter side, here %2.</source>
        <translation>Par défaut : %1 % du petit côté de l’échantillon, ici %2.</translation>
    </message>
    <message>
        <source> (%1 in the paper)</source>
        <translation> (%1 dans l’article)</translation>
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
        <translation>une partie seulement</translation>
    </message>
    <message>
        <source>Part&apos;s left</source>
        <translation>Gauche de la partie</translation>
    </message>
    <message>
        <source>Part&apos;s top</source>
        <translation>Haut de la partie</translation>
    </message>
    <message>
        <source>Part&apos;s width</source>
        <translation>Largeur de la partie</translation>
    </message>
    <message>
        <source>Part&apos;s height</source>
        <translation>Hauteur de la partie</translation>
    </message>
    <message>
        <source>at</source>
        <translation>en</translation>
    </message>
    <message>
        <source>size</source>
        <translation>taille</translation>
    </message>
    <message>
        <source>%1, in pixels of the whole</source>
        <translation>%1, en pixels du tout</translation>
    </message>
</context>
<context>
    <name>texloom::ui::Plot</name>
    <message>
        <source>Numbers</source>
        <translation>Nombres</translation>
    </message>
    <message>
        <source>Show the numbers in a table in place of the plot</source>
        <translation>Montrer les nombres dans un tableau au lieu du graphique</translation>
    </message>
    <message>
        <source>Copy as CSV</source>
        <translation>Copier en CSV</translation>
    </message>
    <message>
        <source>Put the numbers on the clipboard, a line for each value of the horizontal axis</source>
        <translation>Mettre les nombres dans le presse-papiers, une ligne par valeur de l’axe horizontal</translation>
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
        <translation>Il n’y a pas encore d’image sur laquelle peindre ; ouvrez un échantillon ou choisissez d’abord l’image.</translation>
    </message>
    <message>
        <source>There is no exemplar yet whose colours could be painted; open one first.</source>
        <translation>Il n’y a pas encore d’échantillon dont les couleurs pourraient être peintes ; ouvrez-en un d’abord.</translation>
    </message>
    <message>
        <source>The first colours are those of %1.</source>
        <translation>Les premières couleurs sont celles de : %1.</translation>
    </message>
    <message>
        <source>What is there has another size or more than %1 colours, so it is begun anew.</source>
        <translation>Ce qui s’y trouve a une autre taille ou plus de %1 couleurs ; c’est donc recommencé.</translation>
    </message>
    <message>
        <source>%1 completes no picture; choose a method that does: %2.</source>
        <translation>%1 ne complète pas d’images ; choisissez une méthode qui le fait : %2.</translation>
    </message>
    <message>
        <source>There is no picture to extend yet; open an exemplar, or choose the image first.</source>
        <translation>Il n’y a pas encore d’image à étendre ; ouvrez un échantillon, ou choisissez d’abord l’image.</translation>
    </message>
    <message>
        <source>The picture has %1 px now; press Run to make what lies beyond its edges.</source>
        <translation>L’image fait maintenant %1 px ; Lancer fait ce qui se trouve au-delà de ses bords.</translation>
    </message>
    <message>
        <source>To make more of the picture beyond its edges, choose “Extend a picture…” from the menu Tools instead.</source>
        <translation>Pour prolonger l’image au-delà de ses bords, choisissez plutôt « Étendre une image… » dans le menu Outils.</translation>
    </message>
</context>
<context>
    <name>texloom::ui::PortRow</name>
    <message>
        <source>Choose…</source>
        <translation>Choisir…</translation>
    </message>
    <message>
        <source>Choose a file: %1</source>
        <translation>Choisir un fichier : %1</translation>
    </message>
    <message>
        <source>Take the result that is shown: %1</source>
        <translation>Prendre le résultat affiché : %1</translation>
    </message>
    <message>
        <source>Go without: %1</source>
        <translation>S’en passer : %1</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>Rien</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Models (%1)</source>
        <translation>Modèles (%1)</translation>
    </message>
    <message>
        <source>Volumes and slices (%1)</source>
        <translation>Volumes et coupes (%1)</translation>
    </message>
    <message>
        <source>Meshes (%1)</source>
        <translation>Maillages (%1)</translation>
    </message>
    <message>
        <source>Use result</source>
        <translation>Utiliser le résultat</translation>
    </message>
    <message>
        <source>This result has no position map; choose one whose method copies pixels.</source>
        <translation>Ce résultat n’a pas de carte de positions ; choisissez-en un dont la méthode copie des pixels.</translation>
    </message>
    <message>
        <source>This result has no mask; choose one of a method that gives masks.</source>
        <translation>Ce résultat n’a pas de masque ; choisissez-en un d’une méthode qui fournit des masques.</translation>
    </message>
    <message>
        <source>This result has no model of the kind %1; choose one of a method that learns such models.</source>
        <translation>Ce résultat n’a pas de modèle du type %1 ; choisissez-en un d’une méthode qui apprend de tels modèles.</translation>
    </message>
    <message>
        <source>This result has no volume; choose one of a method that gives volumes.</source>
        <translation>Ce résultat n’a pas de volume ; choisissez-en un d’une méthode qui fournit des volumes.</translation>
    </message>
    <message>
        <source>This result has no mesh; choose one of a method that gives meshes.</source>
        <translation>Ce résultat n’a pas de maillage ; choisissez-en un d’une méthode qui fournit des maillages.</translation>
    </message>
    <message>
        <source>This result has no picture; choose another.</source>
        <translation>Ce résultat n’a pas d’image ; choisissez-en un autre.</translation>
    </message>
    <message>
        <source>Paint the mask: %1…</source>
        <translation>Peindre le masque : %1…</translation>
    </message>
    <message>
        <source>There is no result yet that could go in here; press Run first, or choose a file.</source>
        <translation>Il n’y a pas encore de résultat à mettre ici ; lancez d’abord un calcul, ou choisissez un fichier.</translation>
    </message>
    <message>
        <source>Paint: %1…</source>
        <translation>Peindre : %1…</translation>
    </message>
    <message>
        <source>Extend the picture beyond its edges…</source>
        <translation>Étendre l’image au-delà de ses bords…</translation>
    </message>
</context>
<context>
    <name>texloom::ui::PresetEditor</name>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Copier</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Supprimer</translation>
    </message>
    <message>
        <source>&amp;Add a file</source>
        <translation>&amp;Ajouter un fichier</translation>
    </message>
    <message>
        <source>&amp;Remove file</source>
        <translation>&amp;Retirer le fichier</translation>
    </message>
    <message>
        <source>Export presets</source>
        <translation>Préréglages d’export</translation>
    </message>
    <message>
        <source>&amp;Keep</source>
        <translation>&amp;Garder</translation>
    </message>
    <message>
        <source>A preset of your own that begins as the chosen one is</source>
        <translation>Un préréglage à soi, d’abord pareil à celui choisi</translation>
    </message>
    <message>
        <source>The name of the files. $name is the exemplar&apos;s, $map the kind of map; there is $method, $seed, $w, $h, $size and $place, too.</source>
        <translation>Le nom des fichiers. $name est celui de l’échantillon, $map le type de carte ; il y a aussi $method, $seed, $w, $h, $size et $place.</translation>
    </message>
    <message>
        <source>The word that stands for $map in the name of the colours; may be empty</source>
        <translation>Le mot qui remplace $map dans le nom des couleurs ; peut être vide</translation>
    </message>
    <message>
        <source>As they are</source>
        <translation>Telles quelles</translation>
    </message>
    <message>
        <source>OpenGL, green up</source>
        <translation>OpenGL, vert vers le haut</translation>
    </message>
    <message>
        <source>DirectX, green down</source>
        <translation>DirectX, vert vers le bas</translation>
    </message>
    <message>
        <source>&amp;Title</source>
        <translation>&amp;Titre</translation>
    </message>
    <message>
        <source>&amp;Names of files</source>
        <translation>&amp;Noms des fichiers</translation>
    </message>
    <message>
        <source>C&amp;olours are called</source>
        <translation>N&amp;om des couleurs</translation>
    </message>
    <message>
        <source>No&amp;rmals</source>
        <translation>No&amp;rmales</translation>
    </message>
    <message>
        <source>%1, copy</source>
        <translation>%1, copie</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1 : %2</translation>
    </message>
    <message>
        <source>This one comes with Texloom. Copy it to change it.</source>
        <translation>Celui-ci vient avec Texloom. Copiez-le pour le modifier.</translation>
    </message>
    <message>
        <source>New; kept with “Keep”.</source>
        <translation>Nouveau ; enregistré par « Garder ».</translation>
    </message>
    <message>
        <source>On the command line: --export-preset %1</source>
        <translation>En ligne de commande : --export-preset %1</translation>
    </message>
</context>
<context>
    <name>texloom::ui::PresetFilesTable</name>
    <message>
        <source>Smoothness</source>
        <translation>Lissé</translation>
    </message>
    <message>
        <source>Black</source>
        <translation>Noir</translation>
    </message>
    <message>
        <source>White</source>
        <translation>Blanc</translation>
    </message>
    <message>
        <source>Files beside the colours</source>
        <translation>Fichiers à côté des couleurs</translation>
    </message>
    <message>
        <source>$map</source>
        <translation>$map</translation>
    </message>
    <message>
        <source>Holds</source>
        <translation>Contient</translation>
    </message>
    <message>
        <source>Red</source>
        <translation>Rouge</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>Vert</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>Bleu</translation>
    </message>
    <message>
        <source>Alpha</source>
        <translation>Alpha</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Profondeur</translation>
    </message>
    <message>
        <source>The word that stands for $map in the file&apos;s name</source>
        <translation>Le mot qui remplace $map dans le nom du fichier</translation>
    </message>
    <message>
        <source>What the file holds</source>
        <translation>Ce que le fichier contient</translation>
    </message>
    <message>
        <source>Normals</source>
        <translation>Normales</translation>
    </message>
    <message>
        <source>Several, by channel</source>
        <translation>Plusieurs, par canal</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Aucune</translation>
    </message>
    <message>
        <source>Depth of the file</source>
        <translation>Profondeur du fichier</translation>
    </message>
    <message>
        <source>As the map’s</source>
        <translation>Comme la carte</translation>
    </message>
    <message>
        <source>map</source>
        <translation>carte</translation>
    </message>
</context>
<context>
    <name>texloom::ui::PresetMenu</name>
    <message>
        <source>Pre&amp;sets</source>
        <translation>Pré&amp;réglages</translation>
    </message>
    <message>
        <source>&amp;Keep settings as a preset…</source>
        <translation>&amp;Garder les réglages comme préréglage…</translation>
    </message>
    <message>
        <source>&amp;Import presets…</source>
        <translation>&amp;Importer des préréglages…</translation>
    </message>
    <message>
        <source>&amp;Export settings as a preset…</source>
        <translation>&amp;Exporter les réglages comme préréglage…</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Retirer</translation>
    </message>
    <message>
        <source>The preset needs a name with a letter or a figure in it.</source>
        <translation>Le préréglage doit avoir un nom avec une lettre ou un chiffre.</translation>
    </message>
    <message>
        <source>Kept the preset %1.</source>
        <translation>Préréglage %1 gardé.</translation>
    </message>
    <message>
        <source>There is a preset %1 already; rename the file or remove the preset first.</source>
        <translation>Il y a déjà un préréglage %1 ; renommez le fichier ou retirez d’abord le préréglage.</translation>
    </message>
    <message>
        <source>Imported the preset %1.</source>
        <translation>Préréglage %1 importé.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1 : %2</translation>
    </message>
    <message>
        <source>The preset %1 could not be removed.</source>
        <translation>Le préréglage %1 n’a pas pu être retiré.</translation>
    </message>
    <message>
        <source>Keep settings as a preset</source>
        <translation>Garder les réglages comme préréglage</translation>
    </message>
    <message>
        <source>Name of the preset</source>
        <translation>Nom du préréglage</translation>
    </message>
    <message>
        <source>Import presets</source>
        <translation>Importer des préréglages</translation>
    </message>
    <message>
        <source>Presets (*.json)</source>
        <translation>Préréglages (*.json)</translation>
    </message>
    <message>
        <source>Export settings as a preset</source>
        <translation>Exporter les réglages comme préréglage</translation>
    </message>
    <message>
        <source>Wrote the preset %1.</source>
        <translation>Le préréglage %1 a été écrit.</translation>
    </message>
</context>
<context>
    <name>texloom::ui::ReadingBar</name>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Reading %1…</source>
        <translation>Lecture de %1…</translation>
    </message>
    <message>
        <source>Working</source>
        <translation>En cours</translation>
    </message>
    <message>
        <source>Stops; everything stays as it was.</source>
        <translation>Arrête ; tout reste comme avant.</translation>
    </message>
    <message>
        <source>Editing %1…</source>
        <translation>Retouche de %1…</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 et %2 autres</translation>
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
        <translation>La session n’a pas pu être gardée pour récupération et serait perdue en cas de plantage ; libérez de la place ou enregistrez-la ailleurs. %1</translation>
    </message>
</context>
<context>
    <name>texloom::ui::RecoveryDialog</name>
    <message>
        <source>no exemplars</source>
        <translation>aucun échantillon</translation>
    </message>
    <message>
        <source>Recover a session</source>
        <translation>Récupérer une session</translation>
    </message>
    <message>
        <source>Texloom was not closed properly. This session can be recovered.</source>
        <translation>Texloom n’a pas été fermé correctement. Cette session peut être récupérée.</translation>
    </message>
    <message>
        <source>Texloom was not closed properly. These sessions can be recovered, the newest first; those that you leave are offered again.</source>
        <translation>Texloom n’a pas été fermé correctement. Ces sessions peuvent être récupérées, la plus récente d’abord ; celles que vous laissez seront proposées de nouveau.</translation>
    </message>
    <message>
        <source>Sessions</source>
        <translation>Sessions</translation>
    </message>
    <message>
        <source>&amp;Recover</source>
        <translation>&amp;Récupérer</translation>
    </message>
    <message>
        <source>&amp;Throw away</source>
        <translation>&amp;Jeter</translation>
    </message>
    <message>
        <source>Removes those that are chosen in the list.</source>
        <translation>Supprime celles qui sont choisies dans la liste.</translation>
    </message>
    <message>
        <source>&amp;Later</source>
        <translation>Plus &amp;tard</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1 : %2</translation>
    </message>
</context>
<context>
    <name>texloom::ui::ResultActions</name>
    <message>
        <source>&amp;Show</source>
        <translation>&amp;Montrer</translation>
    </message>
    <message>
        <source>Show the chosen result</source>
        <translation>Montrer le résultat choisi</translation>
    </message>
    <message>
        <source>&amp;Restore settings</source>
        <translation>&amp;Rétablir les réglages</translation>
    </message>
    <message>
        <source>Bring the settings of the chosen result back into the form</source>
        <translation>Remettre les réglages du résultat choisi dans le formulaire</translation>
    </message>
    <message>
        <source>&amp;Compare</source>
        <translation>&amp;Comparer</translation>
    </message>
    <message>
        <source>&amp;Differences…</source>
        <translation>&amp;Différences…</translation>
    </message>
    <message>
        <source>&amp;Pin</source>
        <translation>É&amp;pingler</translation>
    </message>
    <message>
        <source>Re&amp;name</source>
        <translation>Re&amp;nommer</translation>
    </message>
    <message>
        <source>Give the chosen result a name of your own</source>
        <translation>Donner un nom à vous au résultat choisi</translation>
    </message>
    <message>
        <source>De&amp;lete</source>
        <translation>&amp;Supprimer</translation>
    </message>
    <message>
        <source>Delete the chosen results</source>
        <translation>Supprimer les résultats choisis</translation>
    </message>
    <message>
        <source>Look at up to 9 chosen results side by side, with their exemplars</source>
        <translation>Voir jusqu’à 9 résultats choisis côte à côte, avec leurs échantillons</translation>
    </message>
    <message>
        <source>List the settings in which two chosen results differ; choose two first</source>
        <translation>Lister les réglages par lesquels deux résultats choisis diffèrent ; choisissez-en d’abord deux</translation>
    </message>
    <message>
        <source>&amp;Limits…</source>
        <translation>&amp;Limites…</translation>
    </message>
    <message>
        <source>Set how much memory and how much of the disk results may take</source>
        <translation>Définir la mémoire et la place sur le disque que les résultats peuvent occuper</translation>
    </message>
    <message>
        <source>&amp;Results</source>
        <translation>&amp;Résultats</translation>
    </message>
    <message>
        <source>Keep the chosen results: pinned ones are never removed automatically</source>
        <translation>Garder les résultats choisis : ceux épinglés ne sont jamais retirés d’office</translation>
    </message>
    <message>
        <source>&amp;Keep and go on</source>
        <translation>&amp;Garder et continuer</translation>
    </message>
    <message>
        <source>Pin the chosen result and choose the next one; 1 to 5 give it stars, 0 none</source>
        <translation>Épingler le résultat choisi et choisir le suivant ; 1 à 5 donnent des étoiles, 0 aucune</translation>
    </message>
</context>
<context>
    <name>texloom::ui::ResultExport</name>
    <message>
        <source>Writing to %1…</source>
        <translation>Écriture dans %1…</translation>
    </message>
    <message>
        <source>Wrote 1 file to %1.</source>
        <translation>1 fichier écrit dans %1.</translation>
    </message>
    <message>
        <source>Wrote %1 files to %2.</source>
        <translation>%1 fichiers écrits dans %2.</translation>
    </message>
    <message>
        <source>Open folder</source>
        <translation>Ouvrir le dossier</translation>
    </message>
    <message>
        <source>The result is on the clipboard.</source>
        <translation>Le résultat est dans le presse-papiers.</translation>
    </message>
</context>
<context>
    <name>texloom::ui::ResultHistory</name>
    <message>
        <source>A result stays in memory only and is lost when the window closes: %1</source>
        <translation>Un résultat reste seulement en mémoire et sera perdu à la fermeture de la fenêtre : %1</translation>
    </message>
    <message>
        <source>This result was removed.</source>
        <translation>Ce résultat a été retiré.</translation>
    </message>
    <message>
        <source>The oldest results that are not pinned were removed, %1 in number, to keep the rest within %2.</source>
        <translation>Les plus anciens résultats non épinglés ont été retirés, au nombre de %1, pour que le reste tienne dans %2.</translation>
    </message>
    <message>
        <source>pinned</source>
        <translation>épinglé</translation>
    </message>
    <message>
        <source>shown</source>
        <translation>affiché</translation>
    </message>
    <message>
        <source>made before the edit</source>
        <translation>fait avant la retouche</translation>
    </message>
    <message>
        <source>%1 of %2 stars</source>
        <translation>%1 étoiles sur %2</translation>
    </message>
    <message>
        <source>before the edit</source>
        <translation>avant la retouche</translation>
    </message>
</context>
<context>
    <name>texloom::ui::ResultPanel</name>
    <message>
        <source>Search results</source>
        <translation>Chercher dans les résultats</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>Résultats</translation>
    </message>
    <message>
        <source>“%1” was deleted.</source>
        <translation>« %1 » a été supprimé.</translation>
    </message>
    <message>
        <source>%1 results were deleted.</source>
        <translation>%1 résultats ont été supprimés.</translation>
    </message>
    <message>
        <source>No result has “%1” in its name, method, exemplar, seed or notes.</source>
        <translation>Aucun résultat n’a « %1 » dans son nom, sa méthode, son échantillon, sa graine ou ses notes.</translation>
    </message>
    <message>
        <source>Every run is kept here with its settings. There is none yet: press Run.</source>
        <translation>Chaque calcul est gardé ici avec ses réglages. Il n’y en a pas encore : cliquez sur Lancer.</translation>
    </message>
    <message>
        <source>%1 in memory, %2 on disk</source>
        <translation>%1 en mémoire, %2 sur le disque</translation>
    </message>
    <message>
        <source>Up to %1 of results stay in memory and up to %2 on the disk; “Limits…” in the Results menu changes that.</source>
        <translation>Jusqu’à %1 de résultats restent en mémoire et jusqu’à %2 sur le disque ; « Limites… » dans le menu Résultats le change.</translation>
    </message>
    <message>
        <source>Results shown</source>
        <translation>Résultats montrés</translation>
    </message>
    <message>
        <source>Which results are shown; the others stay.</source>
        <translation>Quels résultats sont montrés ; les autres restent.</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Tous</translation>
    </message>
    <message>
        <source>Without previews</source>
        <translation>Sans les aperçus</translation>
    </message>
    <message>
        <source>Pinned</source>
        <translation>Épinglés</translation>
    </message>
    <message>
        <source>No result is of the kind chosen above; “All” shows the others.</source>
        <translation>Aucun résultat n’est du genre choisi ci-dessus ; « Tous » montre les autres.</translation>
    </message>
    <message>
        <source>&amp;Pin %1 results</source>
        <translation>É&amp;pingler %1 résultats</translation>
    </message>
    <message>
        <source>&amp;Pin</source>
        <translation>É&amp;pingler</translation>
    </message>
    <message>
        <source>Re&amp;name</source>
        <translation>Re&amp;nommer</translation>
    </message>
    <message>
        <source>De&amp;lete %1 results</source>
        <translation>&amp;Supprimer %1 résultats</translation>
    </message>
    <message>
        <source>De&amp;lete</source>
        <translation>&amp;Supprimer</translation>
    </message>
    <message>
        <source>&amp;Pin “%1”</source>
        <translation>É&amp;pingler « %1 »</translation>
    </message>
    <message>
        <source>Re&amp;name “%1”</source>
        <translation>Re&amp;nommer « %1 »</translation>
    </message>
    <message>
        <source>De&amp;lete “%1”</source>
        <translation>&amp;Supprimer « %1 »</translation>
    </message>
    <message>
        <source>With stars</source>
        <translation>Avec étoiles</translation>
    </message>
    <message>
        <source>Delete pinned results?</source>
        <translation>Supprimer des résultats épinglés ?</translation>
    </message>
    <message>
        <source>“%1” is pinned. Delete it all the same?</source>
        <translation>« %1 » est épinglé. Le supprimer quand même ?</translation>
    </message>
    <message>
        <source>%1 of the %2 chosen results are pinned. Delete all of them?</source>
        <translation>%1 des %2 résultats choisis sont épinglés. Les supprimer tous ?</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Supprimer</translation>
    </message>
</context>
<context>
    <name>texloom::ui::ResultView</name>
    <message>
        <source>Result</source>
        <translation>Résultat</translation>
    </message>
    <message>
        <source>Synthesis map</source>
        <translation>Carte de synthèse</translation>
    </message>
    <message>
        <source>Position map</source>
        <translation>Carte de positions</translation>
    </message>
    <message>
        <source>Every pixel in the colour that the position map gives its source: even areas are copied as they are.</source>
        <translation>Chaque pixel dans la couleur que la carte de positions donne à sa source : les zones unies sont copiées telles quelles.</translation>
    </message>
    <message>
        <source>The legend of the synthesis map: a colour for every pixel of the exemplar.</source>
        <translation>La légende de la carte de synthèse : une couleur pour chaque pixel de l’échantillon.</translation>
    </message>
    <message>
        <source>No result yet. Press Run.</source>
        <translation>Pas encore de résultat. Cliquez sur Lancer.</translation>
    </message>
    <message>
        <source>Open an exemplar to see its position map.</source>
        <translation>Ouvrez un échantillon pour voir sa carte de positions.</translation>
    </message>
    <message>
        <source>No result yet. The map shows where each of its pixels came from.</source>
        <translation>Pas encore de résultat. La carte montre d’où vient chacun de ses pixels.</translation>
    </message>
    <message>
        <source>Exact: every pixel is a copy of the exemplar&apos;s pixel of this colour.</source>
        <translation>Exacte : chaque pixel est une copie du pixel de l’échantillon de cette couleur.</translation>
    </message>
    <message>
        <source>Pixels are blends: each has the colour of the source that weighs most.</source>
        <translation>Les pixels sont des mélanges : chacun a la couleur de la source de plus grand poids.</translation>
    </message>
    <message>
        <source>Estimated: the place in the exemplar that each new pixel is most like.</source>
        <translation>Estimée : l’endroit de l’échantillon auquel chaque nouveau pixel ressemble le plus.</translation>
    </message>
    <message>
        <source>Copied pieces</source>
        <translation>Morceaux copiés</translation>
    </message>
    <message>
        <source>What was copied in one piece: an even colour for each, with black borders.</source>
        <translation>Ce qui a été copié d’un seul tenant : une couleur unie pour chacun, aux bords noirs.</translation>
    </message>
    <message>
        <source>The largest piece copied as it is takes %1 of the result.%2</source>
        <translation>Le plus grand morceau copié tel quel occupe %1 du résultat.%2</translation>
    </message>
    <message>
        <source>This method tells where pixels came from only at its end, or not at all.</source>
        <translation>Cette méthode ne dit d’où viennent les pixels qu’à la fin, ou pas du tout.</translation>
    </message>
    <message>
        <source>Looking at what was copied…</source>
        <translation>Examen de ce qui a été copié…</translation>
    </message>
    <message>
        <source>Estimated</source>
        <translation>Estimée</translation>
    </message>
    <message>
        <source>%1 · estimated</source>
        <translation>%1 · estimée</translation>
    </message>
    <message>
        <source>This method makes new pixels and copies none, so there is no map of where they came from. An estimated one shows what in the exemplar each is most like.</source>
        <translation>Cette méthode crée des pixels et n’en copie aucun, il n’y a donc pas de carte de leur provenance. Une carte estimée montre à quoi chacun ressemble le plus dans l’échantillon.</translation>
    </message>
    <message>
        <source>This method learned from no exemplar, so there is no map of where its pixels came from.</source>
        <translation>Cette méthode n’a appris d’aucun échantillon ; il n’y a donc pas de carte de la provenance de ses pixels.</translation>
    </message>
    <message>
        <source>Does not wrap: make it wrap</source>
        <translation>Non raccordable : rendre raccordable</translation>
    </message>
    <message>
        <source>Ticks both axes under “Wraps” and runs these settings again.</source>
        <translation>Coche les deux axes sous « Raccord » et relance ces réglages.</translation>
    </message>
    <message>
        <source>Made before the edit: run again</source>
        <translation>Fait avant la retouche : relancer</translation>
    </message>
    <message>
        <source>The exemplar was edited since; runs these settings on it as it is now.</source>
        <translation>L’échantillon a été retouché depuis ; relance ces réglages sur son état actuel.</translation>
    </message>
</context>
<context>
    <name>texloom::ui::RunController</name>
    <message>
        <source>%1 · seed %2 · %3</source>
        <translation>%1 · graine %2 · %3</translation>
    </message>
    <message>
        <source>Preparing the pictures</source>
        <translation>Préparation des images</translation>
    </message>
    <message>
        <source>The run goes on, but a crash would lose it; make room on the disk. %1</source>
        <translation>Le calcul continue, mais serait perdu en cas de plantage ; libérez de la place sur le disque. %1</translation>
    </message>
    <message>
        <source>Stopping…</source>
        <translation>Arrêt en cours…</translation>
    </message>
</context>
<context>
    <name>texloom::ui::RunDesk</name>
    <message>
        <source>Started: %1</source>
        <translation>Commencé : %1</translation>
    </message>
    <message>
        <source>Failed: %1: %2</source>
        <translation>Échec : %1 : %2</translation>
    </message>
    <message>
        <source>Finished in %1: %2</source>
        <translation>Terminé en %1 : %2</translation>
    </message>
    <message>
        <source>Note: %1</source>
        <translation>Remarque : %1</translation>
    </message>
    <message>
        <source>Cancelled at %1: %2</source>
        <translation>Annulé à %1 : %2</translation>
    </message>
    <message>
        <source>Stopped at %1 and kept, after %2: %3</source>
        <translation>Arrêté à %1 et gardé, après %2 : %3</translation>
    </message>
</context>
<context>
    <name>texloom::ui::RunDisplay</name>
    <message>
        <source>Quick preview under way: %1</source>
        <translation>Aperçu rapide en cours : %1</translation>
    </message>
    <message>
        <source>Under way: %1</source>
        <translation>En cours : %1</translation>
    </message>
    <message>
        <source>Quick preview</source>
        <translation>Aperçu rapide</translation>
    </message>
    <message>
        <source>Preview 1:%1</source>
        <translation>Aperçu 1:%1</translation>
    </message>
    <message>
        <source>Quick preview: %1</source>
        <translation>Aperçu rapide : %1</translation>
    </message>
    <message>
        <source>Stopped at %1</source>
        <translation>Arrêté à %1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1 : %2</translation>
    </message>
    <message>
        <source>Finished: %1.</source>
        <translation>Terminé : %1.</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Montrer</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volume</translation>
    </message>
    <message>
        <source>There is no picture yet that could be kept; the run ends as soon as there is one.</source>
        <translation>Il n’y a pas encore d’image à garder ; le calcul se termine dès qu’il y en a une.</translation>
    </message>
    <message>
        <source>Cancel it now</source>
        <translation>Annuler maintenant</translation>
    </message>
    <message>
        <source>Cancelled at %1, and nothing of it kept: %2.</source>
        <translation>Annulé à %1, sans rien en garder : %2.</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Matériau</translation>
    </message>
    <message>
        <source>The result and its maps lit, on a shape or a mesh of your own.</source>
        <translation>Le résultat et ses cartes éclairés, sur une forme ou un maillage à vous.</translation>
    </message>
    <message>
        <source>Written to %1.</source>
        <translation>Écrit dans %1.</translation>
    </message>
    <message>
        <source>Open folder</source>
        <translation>Ouvrir le dossier</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>The volume of the result: slices at any place, a block cut open, a mesh.</source>
        <translation>Le volume du résultat : des coupes n’importe où, un bloc ouvert, un maillage.</translation>
    </message>
</context>
<context>
    <name>texloom::ui::RunNotice</name>
    <message>
        <source>Finished</source>
        <translation>Terminé</translation>
    </message>
    <message>
        <source>Failed</source>
        <translation>Échec</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1 : %2</translation>
    </message>
</context>
<context>
    <name>texloom::ui::RunPanel</name>
    <message>
        <source>Progress of the run</source>
        <translation>Progression du calcul</translation>
    </message>
    <message>
        <source>Needs %1 of memory</source>
        <translation>Demande %1 de mémoire</translation>
    </message>
    <message>
        <source>under 1 s</source>
        <translation>moins d’1 s</translation>
    </message>
    <message>
        <source>about %1</source>
        <translation>environ %1</translation>
    </message>
    <message>
        <source>Takes %1 · %2 of memory</source>
        <translation>Durée %1 · %2 de mémoire</translation>
    </message>
    <message>
        <source>Cannot run: %1</source>
        <translation>Impossible : %1</translation>
    </message>
    <message>
        <source>%1 waiting</source>
        <translation>%1 en attente</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>%1, %2 left</source>
        <translation>%1, reste %2</translation>
    </message>
</context>
<context>
    <name>texloom::ui::RunRecovery</name>
    <message>
        <source>A run was broken off at %1: %2.</source>
        <translation>Un calcul s’est interrompu à %1 : %2.</translation>
    </message>
    <message>
        <source>Go on with a run</source>
        <translation>Continuer un calcul</translation>
    </message>
    <message>
        <source>&amp;Go on from %1</source>
        <translation>&amp;Continuer à partir de %1</translation>
    </message>
    <message>
        <source>&amp;Restore settings</source>
        <translation>&amp;Rétablir les réglages</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Abandonner</translation>
    </message>
    <message>
        <source>&amp;Later</source>
        <translation>Plus &amp;tard</translation>
    </message>
</context>
<context>
    <name>texloom::ui::Scope</name>
    <message>
        <source>Histogram, 0 to 255</source>
        <translation>Histogramme, 0 à 255</translation>
    </message>
    <message>
        <source>Waveform: red, green, blue</source>
        <translation>Forme d&apos;onde : rouge, vert, bleu</translation>
    </message>
</context>
<context>
    <name>texloom::ui::ShortcutsDialog</name>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>Raccourcis clavier</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Touches</translation>
    </message>
    <message>
        <source>What they do</source>
        <translation>Ce qu’elles font</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Molette</translation>
    </message>
    <message>
        <source>In a picture: zoom at the cursor</source>
        <translation>Dans une image : zoomer au curseur</translation>
    </message>
    <message>
        <source>Drag</source>
        <translation>Glisser</translation>
    </message>
    <message>
        <source>In a picture: move it</source>
        <translation>Dans une image : la déplacer</translation>
    </message>
    <message>
        <source>Arrow keys</source>
        <translation>Flèches</translation>
    </message>
    <message>
        <source>Shift+arrow keys</source>
        <translation>Maj+flèches</translation>
    </message>
    <message>
        <source>In a picture: move from pixel to pixel and show where each came from</source>
        <translation>Dans une image : aller de pixel en pixel et montrer d’où vient chacun</translation>
    </message>
    <message>
        <source>Double click</source>
        <translation>Double-clic</translation>
    </message>
    <message>
        <source>On a parameter&apos;s label: reset it</source>
        <translation>Sur le nom d’un paramètre : le réinitialiser</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Espace</translation>
    </message>
    <message>
        <source>In the lattice: go to the next handle; the arrow keys move it by 1 px, with Shift by 10 px, with Ctrl by 0.1 px</source>
        <translation>Dans le réseau : poignée suivante ; les flèches la déplacent de 1 px, avec Maj de 10 px, avec Ctrl de 0,1 px</translation>
    </message>
    <message>
        <source>Return</source>
        <translation>Entrée</translation>
    </message>
    <message>
        <source>In a comparison: take over the settings of the picture in use</source>
        <translation>Dans une comparaison : reprendre les réglages de l’image choisie</translation>
    </message>
    <message>
        <source>Ctrl+arrow keys</source>
        <translation>Ctrl+flèches</translation>
    </message>
    <message>
        <source>In a wipe: move the line</source>
        <translation>Dans un volet : déplacer la ligne</translation>
    </message>
    <message>
        <source>Ctrl+Shift+arrow keys</source>
        <translation>Ctrl+Maj+flèches</translation>
    </message>
    <message>
        <source>In a wipe: turn the line</source>
        <translation>Dans un volet : tourner la ligne</translation>
    </message>
    <message>
        <source>Shift+R, G, B, A, C</source>
        <translation>Maj+R, G, B, A, C</translation>
    </message>
    <message>
        <source>In a comparison: show red, green, blue, alpha, or colour</source>
        <translation>Dans une comparaison : montrer rouge, vert, bleu, alpha ou couleur</translation>
    </message>
    <message>
        <source>&amp;Use these keys</source>
        <translation>&amp;Utiliser ces touches</translation>
    </message>
    <message>
        <source>&amp;Back to the original</source>
        <translation>Touches d’&amp;origine</translation>
    </message>
    <message>
        <source>New keys</source>
        <translation>Nouvelles touches</translation>
    </message>
    <message>
        <source>&amp;New keys</source>
        <translation>&amp;Nouvelles touches</translation>
    </message>
    <message>
        <source>%1 is taken by “%2”; give that other keys first.</source>
        <translation>%1 sert déjà à « %2 » ; donnez-lui d’abord d’autres touches.</translation>
    </message>
    <message>
        <source>These keys work only in the place that is named, and cannot be changed.</source>
        <translation>Ces touches appartiennent à l’endroit où elles agissent et restent comme elles sont.</translation>
    </message>
</context>
<context>
    <name>texloom::ui::SliceView</name>
    <message>
        <source>Slice square to %1</source>
        <translation>Coupe perpendiculaire à %1</translation>
    </message>
    <message>
        <source>Oblique slice</source>
        <translation>Coupe oblique</translation>
    </message>
    <message>
        <source>Oblique · %1°, %2°</source>
        <translation>Oblique · %1°, %2°</translation>
    </message>
    <message>
        <source>There is no volume to look at.</source>
        <translation>Il n’y a aucun volume à voir.</translation>
    </message>
    <message>
        <source>Making it…</source>
        <translation>En préparation…</translation>
    </message>
</context>
<context>
    <name>texloom::ui::SolidPanel</name>
    <message>
        <source>Block with a part cut away</source>
        <translation>Bloc dont une partie est coupée</translation>
    </message>
    <message>
        <source>Drag to turn it, with Ctrl to move the cut, which goes through the crosshair; the wheel comes nearer. Double click gives it all the room.</source>
        <translation>Glisser le tourne, avec Ctrl déplace la coupe, qui passe par le réticule ; la molette rapproche. Un double clic lui donne toute la place.</translation>
    </message>
    <message>
        <source>Mesh with the volume&apos;s colours</source>
        <translation>Maillage aux couleurs du volume</translation>
    </message>
    <message>
        <source>Drag to turn it, with Ctrl to move the volume in the mesh; the wheel comes nearer. Double click gives it all the room.</source>
        <translation>Glisser le tourne, avec Ctrl déplace le volume dans le maillage ; la molette rapproche. Un double clic lui donne toute la place.</translation>
    </message>
    <message>
        <source>Oblique slice</source>
        <translation>Coupe oblique</translation>
    </message>
    <message>
        <source>Block</source>
        <translation>Bloc</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Maillage</translation>
    </message>
    <message>
        <source>What the fourth view shows</source>
        <translation>Ce que montre la quatrième vue</translation>
    </message>
    <message>
        <source>How far the slice is turned about the picture&apos;s vertical</source>
        <translation>De combien la coupe est tournée autour de la verticale de l’image</translation>
    </message>
    <message>
        <source>How far the slice is turned about the picture&apos;s horizontal</source>
        <translation>De combien la coupe est tournée autour de l’horizontale de l’image</translation>
    </message>
    <message>
        <source>Cuts at 45° between x and z</source>
        <translation>Coupe à 45° entre x et z</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Rotation</translation>
    </message>
    <message>
        <source>Tilt</source>
        <translation>Inclinaison</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>Rien</translation>
    </message>
    <message>
        <source>Corner</source>
        <translation>Coin</translation>
    </message>
    <message>
        <source>Beyond x</source>
        <translation>Au-delà de x</translation>
    </message>
    <message>
        <source>Above y</source>
        <translation>Au-dessus de y</translation>
    </message>
    <message>
        <source>Before z</source>
        <translation>Devant z</translation>
    </message>
    <message>
        <source>What is cut away at the crosshair</source>
        <translation>Ce qui est coupé au réticule</translation>
    </message>
    <message>
        <source>Voxels along the block&apos;s sides</source>
        <translation>Voxels le long des côtés du bloc</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Coupe</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Côté</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>Sphère</translation>
    </message>
    <message>
        <source>Cube</source>
        <translation>Cube</translation>
    </message>
    <message>
        <source>Cylinder</source>
        <translation>Cylindre</translation>
    </message>
    <message>
        <source>From a file…</source>
        <translation>D’un fichier…</translation>
    </message>
    <message>
        <source>The surface; it needs no places in a texture</source>
        <translation>La surface ; elle n’a pas besoin de places dans une texture</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Surface</translation>
    </message>
    <message>
        <source>Voxels along the mesh&apos;s longest side: more of them are smaller</source>
        <translation>Voxels le long du plus grand côté du maillage : plus il y en a, plus ils sont petits</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Échelle</translation>
    </message>
    <message>
        <source>How far the volume is turned about x</source>
        <translation>De combien le volume est tourné autour de x</translation>
    </message>
    <message>
        <source>How far the volume is turned about y</source>
        <translation>De combien le volume est tourné autour de y</translation>
    </message>
    <message>
        <source>How far the volume is turned about z</source>
        <translation>De combien le volume est tourné autour de z</translation>
    </message>
    <message>
        <source>Mesh to show the volume on</source>
        <translation>Maillage sur lequel montrer le volume</translation>
    </message>
    <message>
        <source>Meshes (*.obj *.ply *.gltf *.glb)</source>
        <translation>Maillages (*.obj *.ply *.gltf *.glb)</translation>
    </message>
</context>
<context>
    <name>texloom::ui::SolidView</name>
    <message>
        <source>Drawing…</source>
        <translation>Dessin en cours…</translation>
    </message>
    <message>
        <source>There is no volume to look at.</source>
        <translation>Il n’y a aucun volume à voir.</translation>
    </message>
</context>
<context>
    <name>texloom::ui::StartPage</name>
    <message>
        <source>Opened last</source>
        <translation>Ouverts en dernier</translation>
    </message>
    <message>
        <source>Exemplars to try</source>
        <translation>Échantillons à essayer</translation>
    </message>
    <message>
        <source>Drop a picture of a material here</source>
        <translation>Déposez ici l’image d’un matériau</translation>
    </message>
    <message>
        <source>Texloom makes more of it: any size, no visible repeats. A first preview starts by itself.</source>
        <translation>Texloom en fait davantage : toute taille, sans répétition visible. Un premier aperçu démarre tout seul.</translation>
    </message>
</context>
<context>
    <name>texloom::ui::StepChain</name>
    <message>
        <source>Method that follows</source>
        <translation>Méthode qui suit</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>Rien</translation>
    </message>
    <message>
        <source>Then</source>
        <translation>Puis</translation>
    </message>
    <message>
        <source>A method that starts from the image made so far and works on it, in the same run and with the same seed.</source>
        <translation>Une méthode qui part de l’image obtenue et la travaille, dans le même calcul et avec la même graine.</translation>
    </message>
</context>
<context>
    <name>texloom::ui::StressDialog</name>
    <message>
        <source>&amp;Start</source>
        <translation>&amp;Démarrer</translation>
    </message>
    <message>
        <source>Stress test</source>
        <translation>Épreuve d’endurance</translation>
    </message>
    <message>
        <source>Rounds</source>
        <translation>Tours</translation>
    </message>
    <message>
        <source>Makes %1 again and again, each time from the texture made before. What a method loses or repeats adds up from round to round.</source>
        <translation>Refait %1 encore et encore, chaque fois à partir de la texture précédente. Ce qu’une méthode perd ou répète s’ajoute de tour en tour.</translation>
    </message>
    <message>
        <source>&amp;Rounds</source>
        <translation>&amp;Tours</translation>
    </message>
    <message>
        <source>Stopped; the rounds made so far stay.</source>
        <translation>Arrêté ; les tours déjà faits restent.</translation>
    </message>
    <message>
        <source>Round %1 of %2…</source>
        <translation>Tour %1 sur %2…</translation>
    </message>
    <message>
        <source>Round %1</source>
        <translation>Tour %1</translation>
    </message>
    <message>
        <source>How far each round is from the exemplar</source>
        <translation>À quelle distance du modèle est chaque tour</translation>
    </message>
    <message>
        <source>round</source>
        <translation>tour</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>distance</translation>
    </message>
    <message>
        <source>colours</source>
        <translation>couleurs</translation>
    </message>
    <message>
        <source>patches, axis 1</source>
        <translation>patchs, axe 1</translation>
    </message>
    <message>
        <source>patches, axis 2</source>
        <translation>patchs, axe 2</translation>
    </message>
    <message>
        <source>patches, whole</source>
        <translation>patchs, entiers</translation>
    </message>
    <message>
        <source>patches, half scale</source>
        <translation>patchs, demi-échelle</translation>
    </message>
    <message>
        <source>patches, quarter scale</source>
        <translation>patchs, quart d’échelle</translation>
    </message>
</context>
<context>
    <name>texloom::ui::SweepDialog</name>
    <message>
        <source>Values across</source>
        <translation>Valeurs en travers</translation>
    </message>
    <message>
        <source>Values down</source>
        <translation>Valeurs en hauteur</translation>
    </message>
    <message>
        <source>Another seed for &amp;each run</source>
        <translation>Une autre graine pour &amp;chaque calcul</translation>
    </message>
    <message>
        <source>At a &amp;preview&apos;s size</source>
        <translation>À la taille d’un &amp;aperçu</translation>
    </message>
    <message>
        <source>Parameter sweep</source>
        <translation>Balayage de paramètres</translation>
    </message>
    <message>
        <source>The &amp;same seed for all</source>
        <translation>La &amp;même graine pour tous</translation>
    </message>
    <message>
        <source>Makes a run for every combination of the values and shows them side by side. Write values as a list (8, 16, 32) or as from:to:count (8:64:5).</source>
        <translation>Fait un calcul pour chaque combinaison des valeurs et les montre côte à côte. Écrivez une liste (8, 16, 32) ou de:à:nombre (8:64:5).</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Démarrer</translation>
    </message>
    <message>
        <source>&amp;Across</source>
        <translation>En tra&amp;vers</translation>
    </message>
    <message>
        <source>&amp;Down</source>
        <translation>En &amp;hauteur</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Graine</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>Rien</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1 : %2</translation>
    </message>
    <message>
        <source>Whole numbers</source>
        <translation>Nombres entiers</translation>
    </message>
    <message>
        <source>1 run</source>
        <translation>1 calcul</translation>
    </message>
    <message>
        <source>%1 runs</source>
        <translation>%1 calculs</translation>
    </message>
</context>
<context>
    <name>texloom::ui::TaskBar</name>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
</context>
<context>
    <name>texloom::ui::ToolForm</name>
    <message>
        <source>Show &amp;before</source>
        <translation>Montrer a&amp;vant</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Appliquer</translation>
    </message>
</context>
<context>
    <name>texloom::ui::Tries</name>
    <message>
        <source>Try &amp;all methods</source>
        <translation>Essayer &amp;toutes les méthodes</translation>
    </message>
    <message>
        <source>Try &amp;some methods…</source>
        <translation>Essayer &amp;quelques méthodes…</translation>
    </message>
    <message>
        <source>Choose methods, make a run with each and compare them</source>
        <translation>Choisir des méthodes, faire un calcul avec chacune et les comparer</translation>
    </message>
    <message>
        <source>Parameter s&amp;weep…</source>
        <translation>&amp;Balayage de paramètres…</translation>
    </message>
    <message>
        <source>Make a run for every combination of some values and compare them</source>
        <translation>Faire un calcul pour chaque combinaison de quelques valeurs et les comparer</translation>
    </message>
    <message>
        <source>%1 · seed %2 · %3</source>
        <translation>%1 · graine %2 · %3</translation>
    </message>
    <message>
        <source>Make a preview with every method but those of solids, the quickest first, and compare them</source>
        <translation>Faire un aperçu avec chaque méthode sauf celles de volumes, les plus rapides d’abord, et les comparer</translation>
    </message>
</context>
<context>
    <name>texloom::ui::UndoHistory</name>
    <message>
        <source>Method</source>
        <translation>Méthode</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Graine</translation>
    </message>
    <message>
        <source>Wraps</source>
        <translation>Raccord</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Réglages</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>A&amp;nnuler</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rétablir</translation>
    </message>
    <message>
        <source>Delete result</source>
        <translation>Supprimer le résultat</translation>
    </message>
    <message>
        <source>Delete results</source>
        <translation>Supprimer les résultats</translation>
    </message>
    <message>
        <source>Input</source>
        <translation>Entrée</translation>
    </message>
</context>
<context>
    <name>texloom::ui::VarianceDialog</name>
    <message>
        <source>&amp;Compute</source>
        <translation>&amp;Calculer</translation>
    </message>
    <message>
        <source>Patch variance</source>
        <translation>Variance des patchs</translation>
    </message>
    <message>
        <source>Sides of the patches in pixels, %1 to %2, with commas between</source>
        <translation>Côtés des patchs en pixels, de %1 à %2, séparés par des virgules</translation>
    </message>
    <message>
        <source>How many of the patches most like one, %1 to %2, with commas between</source>
        <translation>Combien des patchs les plus semblables, de %1 à %2, séparés par des virgules</translation>
    </message>
    <message>
        <source>How many patches to take the mean over: more is surer and slower.</source>
        <translation>Sur combien de patchs faire la moyenne : davantage est plus sûr et plus lent.</translation>
    </message>
    <message>
        <source>&amp;Image</source>
        <translation>&amp;Image</translation>
    </message>
    <message>
        <source>Patch &amp;sizes n</source>
        <translation>&amp;Tailles de patch n</translation>
    </message>
    <message>
        <source>&amp;Neighbours m</source>
        <translation>&amp;Voisins m</translation>
    </message>
    <message>
        <source>&amp;Patches</source>
        <translation>&amp;Patchs</translation>
    </message>
    <message>
        <source>Mean standard deviation of the m patches most like one</source>
        <translation>Écart type moyen des m patchs les plus semblables</translation>
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
        <translation>Cliquez sur Calculer. Là où σ̄ est petit, m patchs se ressemblent et un modèle gaussien les copie ; là où il est grand, le modèle floute.</translation>
    </message>
    <message>
        <source>Give patch sizes from %1 to %2 px with commas between, such as 10, 20, 40.</source>
        <translation>Donnez des tailles de patch de %1 à %2 px séparées par des virgules, par exemple 10, 20, 40.</translation>
    </message>
    <message>
        <source>Give numbers of neighbours from %1 to %2 with commas between, such as 5, 10, 30.</source>
        <translation>Donnez des nombres de voisins de %1 à %2 séparés par des virgules, par exemple 5, 10, 30.</translation>
    </message>
    <message>
        <source>The smallest patch of %1 px does not fit into %2 with a shorter side of %3 px.</source>
        <translation>Le plus petit patch de %1 px ne tient pas dans %2, dont le petit côté fait %3 px.</translation>
    </message>
    <message>
        <source>Comparing patches…</source>
        <translation>Comparaison des patchs…</translation>
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
        <translation>Volume</translation>
    </message>
    <message>
        <source>The voxel under the crosshair</source>
        <translation>Le voxel sous le réticule</translation>
    </message>
    <message>
        <source>All views</source>
        <translation>Toutes les vues</translation>
    </message>
    <message>
        <source>Gives each view its part of the room again</source>
        <translation>Rend à chaque vue sa part de la place</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Enregistrer</translation>
    </message>
    <message>
        <source>Click to bring the crosshair here; drag its lines to move it, and the rest to move along. The wheel zooms, with Ctrl it steps through the volume, like Page Up and Page Down. Double click gives it all the room.</source>
        <translation>Un clic amène le réticule ici ; glisser ses lignes le déplace, glisser le reste fait défiler. La molette agrandit, avec Ctrl elle parcourt le volume, comme Page préc. et Page suiv. Un double clic lui donne toute la place.</translation>
    </message>
    <message>
        <source>Drag to move along, with Shift to turn the slice; a click brings the crosshair here. Double click gives it all the room.</source>
        <translation>Glisser fait défiler, avec Maj tourne la coupe ; un clic amène le réticule ici. Un double clic lui donne toute la place.</translation>
    </message>
    <message>
        <source>Slice as it is seen…</source>
        <translation>La coupe telle qu’on la voit…</translation>
    </message>
    <message>
        <source>Box of voxels…</source>
        <translation>Boîte de voxels…</translation>
    </message>
    <message>
        <source>Mesh with colours…</source>
        <translation>Maillage en couleurs…</translation>
    </message>
    <message>
        <source>Save the slice %1</source>
        <translation>Enregistrer la coupe %1</translation>
    </message>
    <message>
        <source>Pictures (*.png *.tif *.exr)</source>
        <translation>Images (*.png *.tif *.exr)</translation>
    </message>
    <message>
        <source>Save a box of voxels</source>
        <translation>Enregistrer une boîte de voxels</translation>
    </message>
    <message>
        <source>Raw numbers and JSON (*.json);;Numbered slices (*.png *.tif *.exr)</source>
        <translation>Nombres bruts et JSON (*.json);;Coupes numérotées (*.png *.tif *.exr)</translation>
    </message>
    <message>
        <source>There is no mesh yet: choose one in the fourth view, under Mesh.</source>
        <translation>Il n’y a pas encore de maillage : choisissez-en un dans la quatrième vue, sous Maillage.</translation>
    </message>
    <message>
        <source>Mesh with colours</source>
        <translation>Maillage en couleurs</translation>
    </message>
    <message>
        <source>Voxels from one vertex to the next, at most (0 leaves the mesh as it is):</source>
        <translation>Voxels d’un sommet au suivant, au plus (0 laisse le maillage tel quel) :</translation>
    </message>
    <message>
        <source>Save the mesh with its colours</source>
        <translation>Enregistrer le maillage avec ses couleurs</translation>
    </message>
    <message>
        <source>Meshes with colours (*.ply *.obj *.glb)</source>
        <translation>Maillages en couleurs (*.ply *.obj *.glb)</translation>
    </message>
    <message>
        <source>Writing a slice</source>
        <translation>Écriture d’une coupe</translation>
    </message>
    <message>
        <source>Writing a box of voxels</source>
        <translation>Écriture d’une boîte de voxels</translation>
    </message>
    <message>
        <source>Colouring a mesh</source>
        <translation>Coloration d’un maillage</translation>
    </message>
    <message>
        <source>There is no volume to save anything of.</source>
        <translation>Il n’y a aucun volume dont enregistrer quelque chose.</translation>
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
        <translation>Zoom</translation>
    </message>
    <message>
        <source>The picture&apos;s size on the screen: 100 % is one screen pixel for each of its own.</source>
        <translation>La taille de l’image à l’écran : 100 % est un pixel d’écran pour chacun des siens.</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Ajuster</translation>
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
        <translation>arrêté à %1</translation>
    </message>
</context>
</TS>
