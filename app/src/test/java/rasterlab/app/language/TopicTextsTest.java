package rasterlab.app.language;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Properties;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.contract.LineRasterizer;
import rasterlab.engine.circle.CircleTopic;
import rasterlab.engine.circle.EllipseTopic;
import rasterlab.engine.circle.SteppedCircle;
import rasterlab.engine.circle.SteppedEllipse;
import rasterlab.engine.clip.polygon.PolygonClipTopic;
import rasterlab.engine.clip.segment.SegmentClipTopic;
import rasterlab.engine.clip.segment.SteppedSegmentClipper;
import rasterlab.engine.clip.volume.SteppedVolumeClipper;
import rasterlab.engine.clip.volume.VolumeClipTopic;
import rasterlab.engine.color.ColorTopic;
import rasterlab.engine.fill.FillTopic;
import rasterlab.engine.fill.TracedFill;
import rasterlab.engine.geometry.meeting.LinePlaneTopic;
import rasterlab.engine.light.face.FaceTopic;
import rasterlab.engine.light.normals.NormalsTopic;
import rasterlab.engine.light.shade.ShadeTopic;
import rasterlab.engine.line.LineTopic;
import rasterlab.engine.line.Segment;
import rasterlab.engine.line.SteppedLine;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.polygon.inside.PointInPolygonTopic;
import rasterlab.engine.polygon.inside.SteppedPolygonTest;
import rasterlab.engine.polygon.scan.PolygonFillTopic;
import rasterlab.engine.polygon.triangle.PointInTriangleTopic;
import rasterlab.engine.polygon.triangle.SteppedTriangleTest;
import rasterlab.engine.polygon.triangulation.SteppedTriangulator;
import rasterlab.engine.polygon.triangulation.TriangulateTopic;
import rasterlab.engine.spline.CurveTopic;
import rasterlab.engine.spline.SplineFunctionTopic;
import rasterlab.engine.spline.SteppedCurve;
import rasterlab.engine.spline.SteppedSpline;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.LimitReached;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Topic;
import rasterlab.engine.texture.filter.FilterTopic;
import rasterlab.engine.texture.mapping.MappingTopic;
import rasterlab.engine.transform.axis.AxisTopic;
import rasterlab.engine.transform.chain.TransformTopic;
import rasterlab.engine.transform.matrix.MatrixTopic;
import rasterlab.engine.transform.matrix.NamedMatrices;
import rasterlab.engine.transform.matrix.NamedMatrix;
import rasterlab.engine.transform.rotate.RotateTopic;
import rasterlab.engine.transform.view.ViewTopic;
import rasterlab.engine.visibility.depth.DepthBufferTopic;
import rasterlab.engine.visibility.faces.VisibleFacesTopic;
import rasterlab.engine.visibility.hidden.HiddenSurfacesTopic;
import rasterlab.engine.visibility.order.DepthOrderTopic;

/** The Russian of what the engine says in English about methods and hazards. */
class TopicTextsTest {
    private static final Path ROOT = Path.of("src/main/resources/rasterlab/app");
    private static final String ENGLISH = ".en";

    static List<String> topics() {
        return List.of(
                "coordinates/view",
                "coordinates/list",
                "coordinates/turn",
                "coordinates/meeting",
                "line",
                "polygon",
                "clip",
                "visibility",
                "light",
                "row",
                "spline");
    }

    @ParameterizedTest(name = "the English was changed and its translation was not: {0}")
    @MethodSource("topics")
    void eachTranslationStandsBelowWhatTheEngineSays(String topic) throws IOException {
        Properties russian = russian(topic);
        english(topic).forEach((key, text) -> assertEquals(text, russian.get(key + ENGLISH), key));
    }

    @ParameterizedTest(name = "a text has no translation, or a translation no text: {0}")
    @MethodSource("topics")
    void translatesWhatThereIsAndNothingElse(String topic) throws IOException {
        var translated = new TreeSet<>(russian(topic).stringPropertyNames());
        translated.removeIf(key -> key.endsWith(ENGLISH));
        if (topic.equals("spline")) translated.removeIf(key -> key.startsWith("refusal."));
        assertEquals(new TreeSet<>(english(topic).keySet()), translated);
    }

    @Test
    void everyHazardHasAShortRussianName() {
        Texts labels = Texts.of("line", Language.RUSSIAN);
        List<String> nameless =
                new LineTopic()
                        .hazards().stream()
                                .map(hazard -> "hazard." + hazard.name())
                                .filter(key -> !labels.has(key))
                                .toList();
        assertEquals(List.of(), nameless);
    }

    @Test
    void everyHazardOfClippingHasAShortNameInBothLanguages() {
        for (Language language : Language.values()) {
            Texts labels = Texts.of("clip", language);
            var nameless = new TreeMap<String, String>();
            clip("segments", new SegmentClipTopic(), nameless);
            clip("polygon", new PolygonClipTopic(), nameless);
            clip("volume", new VolumeClipTopic(), nameless);
            nameless.keySet().removeIf(key -> !key.startsWith("hazard.") || labels.has(key));
            assertEquals(Map.of(), nameless, language.name());
        }
    }

    @Test
    void everyHazardOfCoordinatesHasAShortNameInBothLanguages() {
        for (Language language : Language.values())
            for (String lab : List.of("list", "turn", "meeting")) {
                Texts labels = Texts.of("coordinates." + lab, language);
                var said = new TreeMap<>(english("coordinates/" + lab));
                if (lab.equals("list")) prefixed(Map.of("transform", new TransformTopic()), said);
                List<String> nameless =
                        said.keySet().stream()
                                .filter(key -> key.startsWith("hazard.") && !labels.has(key))
                                .toList();
                assertEquals(List.of(), nameless, lab + " " + language);
            }
    }

    private static Map<String, String> english(String topic) {
        var said = new TreeMap<String, String>();
        if (topic.equals("spline")) return spline(said);
        if (topic.startsWith("coordinates/")) return coordinates(topic, said);
        if (topic.equals("polygon")) return polygon(said);
        if (topic.equals("row")) return rows(said);
        if (topic.equals("clip")) {
            clip("segments", new SegmentClipTopic(), said);
            clip("polygon", new PolygonClipTopic(), said);
            clip("volume", new VolumeClipTopic(), said);
            return said;
        }
        Stream<? extends Method<?>> methods =
                topic.equals("line")
                        ? new LineTopic().methods().stream()
                        : topic.equals("light")
                                ? new ColorTopic().methods().stream()
                                : Renderer.visibilityMethods().stream();
        methods.forEach(method -> about(method, said));
        prefixed(BESIDE.getOrDefault(topic, Map.of()), said);
        if (topic.equals("light")) hazards(new ColorTopic(), said);
        if (topic.equals("visibility")) hazards(new HiddenSurfacesTopic(), said);
        if (topic.equals("line"))
            for (Hazard<Segment> hazard : new LineTopic().hazards()) {
                said.put("hazard." + hazard.name(), hazard.description());
                refusals(hazard.input(), said);
            }
        return said;
    }

    private static void hazards(Topic<?, ?, ?> topic, Map<String, String> said) {
        for (Hazard<?> hazard : topic.hazards())
            said.put("hazard." + hazard.name(), hazard.description());
    }

    private static final Map<String, Topic<?, ?, ?>> OF_POLYGONS =
            Map.of(
                    "triangle", new PointInTriangleTopic(),
                    "polygon", new PointInPolygonTopic(),
                    "triangulation", new TriangulateTopic(),
                    "fill", new PolygonFillTopic(),
                    "seed", new FillTopic());

    /** Methods of two of these topics have one name, so each text begins with its topic's word. */
    private static Map<String, String> polygon(Map<String, String> said) {
        return prefixed(OF_POLYGONS, said);
    }

    private static final Map<String, Topic<?, ?, ?>> ARCS =
            Map.of("circle", new CircleTopic(), "ellipse", new EllipseTopic());

    /** Topics beside the one that a lab is about. */
    private static final Map<String, Map<String, Topic<?, ?, ?>>> BESIDE =
            Map.of(
                    "line", ARCS,
                    "visibility",
                            Map.of(
                                    "faces",
                                    new VisibleFacesTopic(),
                                    "order",
                                    new DepthOrderTopic()),
                    "light",
                            Map.of(
                                    "shade", new ShadeTopic(),
                                    "face", new FaceTopic(),
                                    "normals", new NormalsTopic()),
                    "coordinates/list",
                            Map.of("rotate-axis", new AxisTopic(), "view", new ViewTopic()));

    private static Map<String, String> prefixed(
            Map<String, Topic<?, ?, ?>> topics, Map<String, String> said) {
        topics.forEach(
                (mode, topic) -> {
                    var methods = new TreeMap<String, String>();
                    for (Method<?> method : topic.methods()) {
                        about(method, methods);
                        String decision = decision(method.implementation());
                        if (!decision.isEmpty()) methods.put(method.name() + ".decision", decision);
                    }
                    methods.forEach((key, text) -> said.put(mode + "." + key, text));
                    for (Hazard<?> hazard : topic.hazards())
                        said.put("hazard." + mode + "." + hazard.name(), hazard.description());
                });
        return said;
    }

    private static String decision(Object method) {
        if (method instanceof SteppedTriangleTest test) return test.valueFormula();
        if (method instanceof SteppedPolygonTest test) return test.countFormula();
        if (method instanceof SteppedCircle circle) return circle.decisionFormula();
        if (method instanceof SteppedEllipse ellipse) return ellipse.decisionFormula();
        if (method instanceof SteppedTriangulator cutter) return cutter.choice();
        return method instanceof TracedFill fill ? fill.waitingMeans() : "";
    }

    @Test
    void everyHazardOfPolygonsAndArcsHasAShortNameInBothLanguages() {
        for (Language language : Language.values()) {
            Texts labels = Texts.of("polygon", language);
            var nameless = new TreeMap<>(polygon(new TreeMap<>()));
            nameless.keySet().removeIf(key -> !key.startsWith("hazard.") || labels.has(key));
            assertEquals(Map.of(), nameless, language.name());
            Texts lines = Texts.of("line", language);
            var arcs = new TreeMap<>(prefixed(ARCS, new TreeMap<>()));
            arcs.keySet().removeIf(key -> !key.startsWith("hazard.") || lines.has(key));
            assertEquals(Map.of(), arcs, language.name());
        }
    }

    /** What methods say when they refuse is looked at in the lab's own tests. */
    private static Map<String, String> spline(Map<String, String> said) {
        for (Topic<?, ?, ?> topic : List.of(new CurveTopic(), new SplineFunctionTopic())) {
            topic.methods().forEach(method -> about(method, said));
            for (Hazard<?> hazard : topic.hazards())
                said.put("hazard." + hazard.name(), hazard.description());
        }
        return said;
    }

    private static Map<String, String> rows(Map<String, String> said) {
        for (Topic<?, ?, ?> topic :
                List.of(new DepthBufferTopic(), new MappingTopic(), new FilterTopic())) {
            topic.methods().forEach(method -> about(method, said));
            for (Hazard<?> hazard : topic.hazards())
                said.put("hazard." + hazard.name(), hazard.description());
        }
        return said;
    }

    private static Map<String, String> coordinates(String lab, Map<String, String> said) {
        Topic<?, ?, ?> topic =
                switch (lab) {
                    case "coordinates/view" -> new TransformTopic();
                    case "coordinates/list" -> new MatrixTopic();
                    case "coordinates/meeting" -> new LinePlaneTopic();
                    default -> new RotateTopic();
                };
        topic.methods().forEach(method -> about(method, said));
        prefixed(BESIDE.getOrDefault(lab, Map.of()), said);
        for (Hazard<?> hazard : topic.hazards())
            said.put("hazard." + hazard.name(), hazard.description());
        if (topic instanceof MatrixTopic)
            for (NamedMatrix matrix : NamedMatrices.all())
                said.put("matrix." + matrix.name(), matrix.meaning());
        return said;
    }

    private static void clip(String mode, Topic<?, ?, ?> topic, Map<String, String> said) {
        for (Hazard<?> hazard : topic.hazards())
            said.put("hazard." + mode + "." + hazard.name(), hazard.description());
        for (Method<?> method : topic.methods()) {
            about(method, said);
            if (method.implementation() instanceof SteppedSegmentClipper stepped)
                said.put("decision." + method.name(), stepped.decisionFormula());
            if (method.implementation() instanceof SteppedVolumeClipper stepped)
                said.put("decision." + method.name(), stepped.decisionFormula());
        }
    }

    /** What methods say when they refuse, as a pattern with the number of steps left open. */
    private static void refusals(Segment segment, Map<String, String> said) {
        var topic = new LineTopic();
        for (Method<LineRasterizer> method : topic.methods())
            try {
                topic.record(method.implementation(), segment, 100);
            } catch (IllegalArgumentException refusal) {
                String steps = String.valueOf(segment.steps());
                said.put(
                        method.name() + ".refusal",
                        refusal.getMessage().replace(steps, "{0,number,#}"));
            } catch (LimitReached longer) {
                assertNotNull(longer.recorded(), method.name());
            }
    }

    private static void about(Method<?> method, Map<String, String> said) {
        Method.About about = method.about();
        said.put(method.name() + ".formula", about.formula());
        said.put(method.name() + ".invariant", about.invariant());
        said.put(method.name() + ".cost", about.cost());
        said.put(method.name() + ".failures", about.failures());
        said.put(method.name() + ".source", about.source());
        if (method.implementation() instanceof SteppedLine stepped)
            said.put("decision." + method.name(), stepped.decisionFormula());
        if (method.implementation() instanceof SteppedCurve stepped)
            said.put("decision." + method.name(), stepped.decisionFormula());
        if (method.implementation() instanceof SteppedSpline stepped)
            said.put("decision." + method.name(), stepped.decisionFormula());
    }

    private static Properties russian(String topic) throws IOException {
        var properties = new Properties();
        try (var in = Files.newBufferedReader(ROOT.resolve(topic + "/topic_ru.properties"))) {
            properties.load(in);
        }
        return properties;
    }
}
