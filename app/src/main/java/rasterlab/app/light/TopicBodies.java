package rasterlab.app.light;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.joml.Vector3d;
import rasterlab.app.canvas.lab.GivenInput;
import rasterlab.app.canvas.method.ShownDifference;
import rasterlab.app.mine.OwnMethods;
import rasterlab.contract.Attenuation;
import rasterlab.contract.LightSource;
import rasterlab.contract.LitFace;
import rasterlab.contract.LitPoint;
import rasterlab.contract.Reflection;
import rasterlab.contract.SurfaceMaterial;
import rasterlab.engine.color.Colors;
import rasterlab.engine.light.Substance;
import rasterlab.engine.light.face.FacePoints;
import rasterlab.engine.light.face.FaceTopic;
import rasterlab.engine.light.normals.NormalsTopic;
import rasterlab.engine.light.normals.TriangleSurface;
import rasterlab.engine.light.shade.LitPoints;
import rasterlab.engine.light.shade.ShadeTopic;
import rasterlab.engine.naming.Named;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.study.Topic;
import rasterlab.engine.transform.PictureFit;
import rasterlab.engine.transform.SphericalView;

/**
 * Hazards of the topics about light as bodies, lamps and eyes of the lab; a body of theirs is named
 * {@code TOPIC/HAZARD}, or {@code TOPIC/HAZARD/METHOD} with that method's normals.
 */
public final class TopicBodies {
    /** Pixels from the middle to the farthest corner in a picture of 800×600. */
    private static final double SCALE = 190;

    /** How far a lamp that stands in the point stands from it in the lab, whose lamps do not. */
    private static final double BESIDE = 0.05;

    /** How far the eye is from a point whose direction to the eye is known. */
    private static final double AWAY = 2;

    /** Radians between a surface's normal and the look at it. */
    private static final double SLANT = 0.5;

    private static final double UNIT = 1e-9;
    private static final int BACKGROUND = 0xFFFFFF;
    private static final LightChoice.LightMarks MIDDLE =
            new LightChoice.LightMarks(0.1, 0.5, 0.9, 0.5, 0.5, 0.5);
    private static final List<Topic<?, ?, ?>> TOPICS =
            List.of(new NormalsTopic(), new FaceTopic(), new ShadeTopic());

    private TopicBodies() {}

    public static boolean has(String body) {
        return body.indexOf('/') > 0;
    }

    /** How the lab shows that input of a topic otherwise than it is. */
    static List<ShownDifference> differences(Object input, String method) {
        var differences =
                new ArrayList<ShownDifference>(
                        TopicMesh.of(input, ownNormals(input, method)).differences());
        if (input instanceof LitPoints points) {
            LitPoint point = points.points().get(0);
            if (point.distance() == 0)
                differences.add(
                        ShownDifference.of(
                                ShownDifference.ShownDifferenceKind.LAMP_BESIDE, BESIDE));
            if (SpotPlace.of(point).isPresent())
                differences.add(
                        ShownDifference.of(ShownDifference.ShownDifferenceKind.POINT_ASIDE));
        }
        return differences;
    }

    /** The method if its normals are those that the body is shown with, and the lab has it not. */
    private static String ownNormals(Object input, String method) {
        boolean shown = method.isEmpty() || LitBody.NORMALS.contains(method);
        return input instanceof TriangleSurface && !shown ? method : "";
    }

    /** The body's scene; its light and its finish are the choice's. */
    static Scene scene(String body) {
        String[] words = body.split("/");
        Mesh mesh =
                TopicMesh.of(input(words[0], words[1]), words.length > 2 ? words[2] : "").mesh();
        double reach = 0;
        for (int v = 0; v < mesh.vertexCount(); v++)
            reach = Math.max(reach, Math.hypot(Math.hypot(mesh.x(v), mesh.y(v)), mesh.z(v)));
        return Scene.dull(
                body.replace('/', '-'),
                mesh,
                new int[mesh.faceCount()],
                BACKGROUND,
                LightChoice.first().camera(),
                SCALE / reach);
    }

    /** The input whose body it is; empty for a scene's. */
    public static Optional<Object> input(LitBody body) {
        String[] words = body.name().split("/");
        return has(body.name()) ? Optional.of(input(words[0], words[1])) : Optional.empty();
    }

    private static Object input(String of, String hazard) {
        return GivenInput.any(topic(of), hazard).input();
    }

    private static Topic<?, ?, ?> topic(String name) {
        return Named.find("topic", name, TOPICS, Topic::name);
    }

    /** The body of an input: of a hazard by its name, of any other by what it is. */
    static String body(String topic, String hazard, Object input) {
        return topic + "/" + (hazard.isEmpty() ? given(topic(topic), input) : hazard);
    }

    @SuppressWarnings("unchecked") // of that topic
    private static <I> String given(Topic<?, I, ?> topic, Object input) {
        return GivenInput.name(topic, (I) input);
    }

    /** The choice that shows an input. */
    public static LightChoice shown(String body, Object input, String method) {
        LightChoice first =
                LightChoice.first().with(new LitBody(body, LitBody.COARSEST, LitBody.OWN));
        if (input instanceof FacePoints points) return face(first, points.face());
        if (input instanceof LitPoints points) return point(first, points.points().get(0), method);
        String own = ownNormals(input, method);
        LitBody shown =
                own.isEmpty()
                        ? new LitBody(body, LitBody.COARSEST, method.isEmpty() ? "plain" : method)
                        : new LitBody(body + "/" + own, LitBody.COARSEST, LitBody.OWN);
        return first.with(shown)
                .with(facing((TriangleSurface) input))
                .with(MIDDLE)
                .withArrows(true);
    }

    /** Looks slantingly at the side that most of the surface has; at a closed one, as usual. */
    private static SphericalView facing(TriangleSurface bare) {
        Mesh mesh = TopicMesh.of(bare, "").mesh();
        var side = new Vector3d();
        for (int face = 0; face < mesh.faceCount(); face++)
            side.add(mesh.normalX(face), mesh.normalY(face), mesh.normalZ(face));
        SphericalView usual = LightChoice.first().camera();
        if (side.length() < UNIT) return usual;
        double phi = Math.acos(side.z / side.length());
        double turned = phi + (phi < Math.PI / 2 ? SLANT : -SLANT);
        return new SphericalView(Math.atan2(side.y, side.x), turned, usual.rho());
    }

    private static LightChoice face(LightChoice first, LitFace face) {
        double[] middle = TopicMesh.middle(face.corners());
        return lit(first, face.material(), face.globalAmbient()[0])
                .withLamp(0, lamp(TopicMesh.moved(face.lamp(), middle)))
                .with(camera(TopicMesh.moved(face.eye(), middle)))
                .with(MIDDLE);
    }

    private static LightChoice point(LightChoice first, LitPoint point, String method) {
        boolean phong = method.startsWith("phong");
        double distance = point.distance() == 0 ? BESIDE : point.distance();
        double[] at = Arrays.stream(point.toLight()).map(x -> x * distance).toArray();
        double[] eye = Arrays.stream(point.toEye()).map(x -> x * AWAY).toArray();
        Attenuation attenuation = point.light().attenuation();
        Lamp lamp =
                lamp(at).attenuated(
                                attenuation.constant(),
                                attenuation.linear() * Lamp.UNIT,
                                attenuation.quadratic() * Lamp.UNIT * Lamp.UNIT);
        LightChoice shown =
                lit(first, point.material(), point.globalAmbient()[0])
                        .with(phong ? Reflection.PHONG : Reflection.BLINN_PHONG)
                        .withTwoSides(false)
                        .withLamp(0, lamp)
                        .with(camera(eye))
                        .with(MIDDLE);
        return SpotPlace.of(point).map(spot -> aside(shown, spot, point.light())).orElse(shown);
    }

    /**
     * The point to the left of the middle, at which the lab's spots look, and in the same light.
     */
    private static LightChoice aside(LightChoice shown, SpotPlace spot, LightSource light) {
        Lamp lamp =
                lamp(new double[] {spot.lampX(), 0, spot.lampZ()})
                        .withKind(Lamp.LampKind.SPOT)
                        .withCutoff(light.cone().cutoff())
                        .withExponent(light.cone().exponent());
        double scale = scene(shown.body().name()).pictureScale();
        double atX = 0.5 + spot.x() * scale * shown.zoom() / PictureFit.NATURAL_WIDTH;
        return shown.withLamp(0, lamp)
                .with(new SphericalView(-Math.PI / 2, 0, shown.camera().rho()))
                .with(new LightChoice.LightMarks(0.1, 0.5, 0.9, 0.5, atX, 0.5));
    }

    /** A choice of one lamp and a material like {@code like}, whose shares are all grey. */
    private static LightChoice lit(LightChoice first, SurfaceMaterial like, double ambient) {
        Substance gray = Substance.SILVER;
        SurfaceMaterial whole = gray.surface();
        var material =
                new MaterialChoice(
                        gray,
                        like.ambient()[0] / whole.ambient()[0],
                        like.diffuse()[0] / whole.diffuse()[0],
                        like.specular()[0] / whole.specular()[0],
                        0,
                        like.shininess());
        return first.selecting(1).shrunk().with(material).withAmbient(ambient);
    }

    private static Lamp lamp(double[] at) {
        return Lamp.at(at[0], at[1], at[2]);
    }

    private static SphericalView camera(double[] eye) {
        double distance = Math.hypot(Math.hypot(eye[0], eye[1]), eye[2]);
        return new SphericalView(
                Math.atan2(eye[1], eye[0]),
                Math.acos(eye[2] / distance),
                Math.min(SphericalView.FARTHEST, distance));
    }

    /** How the lab shows a hazard's input, of a topic about light, otherwise than it is. */
    public static List<ShownDifference> shownDifferences(Object input, String method) {
        String shown = method.equals(OwnMethods.NAME) ? "" : method;
        if (!(input instanceof Colors colors)) return differences(input, shown);
        return ColorChoice.first().with(colors, "formula").outside()
                ? List.of(ShownDifference.of(ShownDifference.ShownDifferenceKind.COLOR_CUT))
                : List.of();
    }
}
