package rasterlab.exercises.scene;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.stream.Stream;
import rasterlab.engine.light.LightTerm;
import rasterlab.engine.naming.Named;
import rasterlab.engine.pipeline.Cull;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.pipeline.ShadingMethod;
import rasterlab.engine.pipeline.Stereo;
import rasterlab.engine.pipeline.paint.DepthCue;
import rasterlab.engine.pipeline.paint.TextureMode;
import rasterlab.engine.pipeline.wire.HiddenLines;
import rasterlab.engine.texture.TextureEnvironment;
import rasterlab.engine.texture.Wrap;
import rasterlab.engine.transform.Projection;
import rasterlab.engine.transform.SphericalView;
import rasterlab.engine.visibility.ClipPlane;

/**
 * One thing that a scene file may say about how its scene is drawn: its field, and how its value is
 * read and written.
 */
public final class SceneSetting<T> {
    private static final JsonNodeFactory JSON = JsonNodeFactory.instance;
    private static final double LARGEST = 1e30;

    /** The largest and, as 1 / it, the smallest factor on a scene's size. */
    public static final double MOST_ZOOM = 1e6;

    /** The largest angle of a camera: of larger ones rounding leaves no direction to speak of. */
    public static final double MOST_RADIANS = 1e6;

    private static final double LEAST_EYES = 1e-6;

    public static final SceneSetting<SphericalView> CAMERA =
            new SceneSetting<>("camera", SceneSetting::camera, SceneSetting::json);
    public static final SceneSetting<Projection> PROJECTION =
            named("projection", List.of(Projection.values()), Projection::code);

    /** The scene's size in the picture, times this. */
    public static final SceneSetting<Double> ZOOM = number("zoom", 1 / MOST_ZOOM, MOST_ZOOM);

    /** The smallest depth that is drawn, in world units along the line of sight. */
    public static final SceneSetting<Double> NEAR = number("near", -LARGEST, LARGEST);

    /** The largest one. */
    public static final SceneSetting<Double> FAR = number("far", -LARGEST, LARGEST);

    public static final SceneSetting<List<ClipPlane>> CLIP_PLANES =
            new SceneSetting<>(
                    "clipPlanes", place -> place.made(SceneSetting::planes), SceneSetting::json);

    /** One of {@code Renderer.visibilities()}, or {@code Renderer.SURFACES}. */
    public static final SceneSetting<String> VISIBILITY =
            named(
                    "visibility",
                    Stream.concat(Renderer.visibilities().stream(), Stream.of(Renderer.SURFACES))
                            .toList(),
                    name -> name);

    public static final SceneSetting<ShadingMethod> SHADING =
            named("shading", List.of(ShadingMethod.values()), ShadingMethod::code);
    public static final SceneSetting<TextureMode> TEXTURE =
            named("texture", List.of(TextureMode.values()), TextureMode::code);

    /**
     * A PNG, JPEG, GIF or BMP picture to lay on all faces, by its name in the scene file's folder.
     */
    public static final SceneSetting<String> TEXTURE_IMAGE =
            new SceneSetting<>("textureImage", SceneJsonPlace::text, JSON::textNode);

    public static final SceneSetting<Wrap> WRAP =
            named("wrap", List.of(Wrap.values()), SceneSetting::code);
    public static final SceneSetting<TextureEnvironment.Mode> ENVIRONMENT =
            named("environment", List.of(TextureEnvironment.Mode.values()), SceneSetting::code);
    public static final SceneSetting<Set<LightTerm>> TERMS =
            new SceneSetting<>(
                    "terms", place -> place.made(SceneSetting::terms), SceneSetting::json);
    public static final SceneSetting<Boolean> TWO_SIDED = flag("twoSided");
    public static final SceneSetting<Cull> CULL = named("cull", List.of(Cull.values()), Cull::code);
    public static final SceneSetting<HiddenLines> HIDDEN_LINES =
            named("hiddenLines", List.of(HiddenLines.values()), HiddenLines::code);

    /** The crease, in degrees. */
    public static final SceneSetting<Double> CREASE = number("crease", 0, 180);

    public static final SceneSetting<Boolean> OUTLINE = flag("outline");
    public static final SceneSetting<DepthCue> DEPTH_CUE =
            new SceneSetting<>(
                    "depthCue",
                    place -> place.made(p -> new DepthCue(p.number(0, 1))),
                    cue -> JSON.numberNode(cue.strength()));
    public static final SceneSetting<Stereo.StereoMode> STEREO =
            named("stereo", List.of(Stereo.StereoMode.values()), Stereo.StereoMode::code);

    /** The distance of the two eyes in world units. */
    public static final SceneSetting<Double> EYES =
            number("eyes", LEAST_EYES, SphericalView.FARTHEST);

    /** The settings that a file has beside its scene. */
    public static final List<SceneSetting<?>> OF_VIEW =
            List.of(CAMERA, PROJECTION, ZOOM, NEAR, FAR, CLIP_PLANES);

    /** The settings that a file has under {@code look}. */
    public static final List<SceneSetting<?>> OF_LOOK =
            List.of(
                    VISIBILITY,
                    SHADING,
                    TEXTURE,
                    TEXTURE_IMAGE,
                    WRAP,
                    ENVIRONMENT,
                    TERMS,
                    TWO_SIDED,
                    CULL,
                    HIDDEN_LINES,
                    CREASE,
                    OUTLINE,
                    DEPTH_CUE,
                    STEREO,
                    EYES);

    private final String field;
    private final Function<SceneJsonPlace, T> reader;
    private final Function<T, JsonNode> writer;

    private SceneSetting(
            String field, Function<SceneJsonPlace, T> reader, Function<T, JsonNode> writer) {
        this.field = field;
        this.reader = reader;
        this.writer = writer;
    }

    private static <E> SceneSetting<E> named(
            String field, List<E> known, Function<E, String> code) {
        return new SceneSetting<>(
                field,
                place -> place.made(given -> Named.find(field, given.text(), known, code)),
                value -> JSON.textNode(code.apply(value)));
    }

    private static SceneSetting<Double> number(String field, double least, double most) {
        return new SceneSetting<>(field, place -> place.number(least, most), JSON::numberNode);
    }

    private static SceneSetting<Boolean> flag(String field) {
        return new SceneSetting<>(field, SceneJsonPlace::flag, JSON::booleanNode);
    }

    /** The setting's name in a file. */
    public String field() {
        return field;
    }

    /** Where a file has it, such as {@code $.look.shading}. */
    public String place() {
        return (OF_LOOK.contains(this) ? "$.look." : "$.") + field;
    }

    T read(SceneJsonPlace place) {
        return reader.apply(place);
    }

    JsonNode written(T value) {
        return writer.apply(value);
    }

    @Override
    public String toString() {
        return field;
    }

    private static SphericalView camera(SceneJsonPlace place) {
        place.object("theta", "phi", "rho");
        double theta = place.at("theta").number(-MOST_RADIANS, MOST_RADIANS);
        double phi = place.at("phi").number(-MOST_RADIANS, MOST_RADIANS);
        double rho = place.at("rho").number(SphericalView.NEAREST, SphericalView.FARTHEST);
        return new SphericalView(theta, phi, rho);
    }

    private static ObjectNode json(SphericalView camera) {
        return JSON.objectNode()
                .put("theta", camera.thetaRadians())
                .put("phi", camera.phiRadians())
                .put("rho", camera.rho());
    }

    private static List<ClipPlane> planes(SceneJsonPlace place) {
        return ClipPlane.checked(
                place.members().stream().map(member -> member.made(SceneSetting::plane)).toList());
    }

    private static ClipPlane plane(SceneJsonPlace place) {
        double[] p = place.numbers(4, -ClipPlane.LARGEST, ClipPlane.LARGEST);
        return new ClipPlane(p[0], p[1], p[2], p[3]);
    }

    private static ArrayNode json(List<ClipPlane> planes) {
        ArrayNode array = JSON.arrayNode();
        for (ClipPlane plane : planes)
            array.addArray().add(plane.a()).add(plane.b()).add(plane.c()).add(plane.d());
        return array;
    }

    private static Set<LightTerm> terms(SceneJsonPlace place) {
        Set<LightTerm> terms = new TreeSet<>();
        for (SceneJsonPlace member : place.members()) {
            LightTerm term = member.made(p -> LightTerm.named(p.text()));
            if (!terms.add(term)) throw member.wrong("names '" + term.code() + "' twice");
        }
        return Set.copyOf(terms);
    }

    private static ArrayNode json(Set<LightTerm> terms) {
        ArrayNode array = JSON.arrayNode();
        for (LightTerm term : new TreeSet<>(terms)) array.add(term.code());
        return array;
    }

    private static String code(Enum<?> constant) {
        return constant.name().toLowerCase(Locale.ROOT).replace('_', '-');
    }
}
