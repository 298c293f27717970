package rasterlab.exercises.topic;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import rasterlab.contract.AxisRotation;
import rasterlab.contract.CircleRasterizer;
import rasterlab.contract.ColorConverter;
import rasterlab.contract.CurveTracer;
import rasterlab.contract.DepthFormat;
import rasterlab.contract.DepthOrder;
import rasterlab.contract.EllipseRasterizer;
import rasterlab.contract.EyeView;
import rasterlab.contract.FaceShader;
import rasterlab.contract.LinePlane;
import rasterlab.contract.LineRasterizer;
import rasterlab.contract.MatrixFormula;
import rasterlab.contract.PlaneRotation;
import rasterlab.contract.PointInPolygon;
import rasterlab.contract.PointInTriangle;
import rasterlab.contract.PointShader;
import rasterlab.contract.PointTransformer;
import rasterlab.contract.PolygonClipper;
import rasterlab.contract.PolygonFiller;
import rasterlab.contract.SeedFiller;
import rasterlab.contract.SegmentClipper;
import rasterlab.contract.SplineFunction;
import rasterlab.contract.TextureFilter;
import rasterlab.contract.TextureMapper;
import rasterlab.contract.Triangulator;
import rasterlab.contract.VertexNormals;
import rasterlab.contract.VisibleFaces;
import rasterlab.contract.VolumeClipper;
import rasterlab.engine.Topics;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.TopicGrading;
import rasterlab.exercises.graded.AnyGrading;
import rasterlab.exercises.graded.ClipGrading;
import rasterlab.exercises.graded.FaceGrading;
import rasterlab.exercises.graded.ShadeGrading;
import rasterlab.exercises.graded.TopicPart;
import rasterlab.exercises.graded.TriangleGrading;
import rasterlab.exercises.line.LineGrading;

/** The topics that can be graded, in the course's order. A further topic is one more line here. */
public final class TopicGradings {
    private static final List<Map.Entry<String, Class<?>>> CONTRACTS =
            List.of(
                    Map.entry("line", LineRasterizer.class),
                    Map.entry("circle", CircleRasterizer.class),
                    Map.entry("ellipse", EllipseRasterizer.class),
                    Map.entry("fill", SeedFiller.class),
                    Map.entry("polygon-fill", PolygonFiller.class),
                    Map.entry("line-plane", LinePlane.class),
                    Map.entry("point-in-triangle", PointInTriangle.class),
                    Map.entry("point-in-polygon", PointInPolygon.class),
                    Map.entry("triangulate", Triangulator.class),
                    Map.entry("clip-segment", SegmentClipper.class),
                    Map.entry("clip-polygon", PolygonClipper.class),
                    Map.entry("clip-volume", VolumeClipper.class),
                    Map.entry("matrix", MatrixFormula.class),
                    Map.entry("transform", PointTransformer.class),
                    Map.entry("view", EyeView.class),
                    Map.entry("rotate", PlaneRotation.class),
                    Map.entry("rotate-axis", AxisRotation.class),
                    Map.entry("visible-faces", VisibleFaces.class),
                    Map.entry("depth-order", DepthOrder.class),
                    Map.entry("depth-buffer", DepthFormat.class),
                    Map.entry("spline-function", SplineFunction.class),
                    Map.entry("curve", CurveTracer.class),
                    Map.entry("shade", PointShader.class),
                    Map.entry("vertex-normals", VertexNormals.class),
                    Map.entry("shade-face", FaceShader.class),
                    Map.entry("color", ColorConverter.class),
                    Map.entry("texture-mapping", TextureMapper.class),
                    Map.entry("texture-filter", TextureFilter.class));

    private TopicGradings() {}

    public static List<String> names() {
        return CONTRACTS.stream().map(Map.Entry::getKey).toList();
    }

    /** What a student may be asked to implement. */
    public static List<Class<?>> contracts() {
        return Stream.concat(
                        CONTRACTS.stream().<Class<?>>map(Map.Entry::getValue),
                        TopicPart.all().stream().<Class<?>>map(TopicPart::contract))
                .toList();
    }

    /** Names of the smaller contracts that an exercise on that topic may ask for. */
    public static List<String> parts(String topic) {
        return TopicPart.all().stream()
                .filter(one -> one.topic().equals(topic))
                .map(TopicPart::name)
                .toList();
    }

    /** The grading of an exercise: of its topic, or of the part that it asks for. */
    public static TopicGrading of(Exercise exercise) {
        return named(exercise.topic(), exercise.contract());
    }

    /**
     * The grading of a topic, or of a part of it.
     *
     * @param contract simple name of a smaller one; empty for the topic's own
     * @throws IllegalArgumentException when there is no such topic or part; names those there are
     */
    public static TopicGrading named(String topic, Optional<String> contract) {
        if (contract.isEmpty()) return named(topic);
        TopicPart<?, ?> part =
                TopicPart.of(topic, contract.get())
                        .orElseThrow(
                                () ->
                                        new IllegalArgumentException(
                                                "no contract '%s' of '%s'; there are %s"
                                                        .formatted(
                                                                contract.get(),
                                                                topic,
                                                                parts(topic))));
        return AnyGrading.ofPart(Topics.named(topic), part);
    }

    /**
     * The topic of that name.
     *
     * @throws IllegalArgumentException when there is none; names those there are
     */
    public static TopicGrading named(String name) {
        return switch (name) {
            case "line" -> new LineGrading();
            case "point-in-triangle" -> new TriangleGrading();
            case "clip-segment" -> new ClipGrading();
            case "shade" -> new ShadeGrading();
            case "shade-face" -> new FaceGrading();
            default -> AnyGrading.of(Topics.named(name), contract(name));
        };
    }

    private static Class<?> contract(String topic) {
        return CONTRACTS.stream()
                .filter(one -> one.getKey().equals(topic))
                .findFirst()
                .<Class<?>>map(Map.Entry::getValue)
                .orElseThrow(
                        () ->
                                new IllegalArgumentException(
                                        "no topic '"
                                                + topic
                                                + "' can be graded; there are "
                                                + String.join(", ", names())));
    }
}
