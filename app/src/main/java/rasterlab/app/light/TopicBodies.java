package rasterlab.app.light;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.joml.Vector3d;
import rasterlab.app.canvas.Unshown;
import rasterlab.contract.LightSource;
import rasterlab.contract.LitFace;
import rasterlab.contract.LitPoint;
import rasterlab.contract.Reflection;
import rasterlab.contract.SurfaceMaterial;
import rasterlab.engine.light.Substance;
import rasterlab.engine.light.face.FacePoints;
import rasterlab.engine.light.face.FaceTopic;
import rasterlab.engine.light.normals.NormalsTopic;
import rasterlab.engine.light.normals.Triangles;
import rasterlab.engine.light.shade.LitPoints;
import rasterlab.engine.light.shade.ShadeTopic;
import rasterlab.engine.naming.Named;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Topic;
import rasterlab.engine.transform.SphericalView;

/**
 * Hazards of the topics about light as bodies, lamps and eyes of the lab; a body of theirs is named
 * {@code TOPIC/HAZARD}.
 */
final class TopicBodies {
    /** World units from the middle to the farthest corner of a body that has no lamp and eye. */
    private static final double REACH = 64;

    /** Pixels of the same in a picture of 800×600. */
    private static final double SCALE = 190;

    /** Half the side of the face around a single point; its light is nearly that of the point. */
    private static final double PATCH = 0.02;

    /** How far the eye is from a point whose direction to the eye is known. */
    private static final double AWAY = 2;

    /** Radians between a surface's normal and the look at it. */
    private static final double SLANT = 0.5;

    private static final double UNIT = 1e-9;
    private static final int BACKGROUND = 0xFFFFFF;
    private static final LightChoice.Marks MIDDLE =
            new LightChoice.Marks(0.1, 0.5, 0.9, 0.5, 0.5, 0.5);
    private static final List<Topic<?, ?, ?>> TOPICS =
            List.of(new NormalsTopic(), new FaceTopic(), new ShadeTopic());

    private TopicBodies() {}

    static boolean has(String body) {
        return body.indexOf('/') > 0;
    }

    /** Why the lab cannot show that input of a topic; empty where it can. */
    static Optional<Unshown> obstacle(Object input) {
        if (input instanceof LitPoints points) {
            LitPoint point = points.points().get(0);
            double[] n = point.normal();
            double length = Math.hypot(Math.hypot(n[0], n[1]), n[2]);
            if (!(Math.abs(length - 1) <= UNIT)) return Optional.of(Unshown.NORMAL_LENGTH);
            if (point.distance() == 0 || aims(point.light())) return Optional.of(Unshown.LAMP);
        }
        if (input instanceof Triangles bare && !(largest(bare.vertices()) >= SphericalView.NEAREST))
            return Optional.of(Unshown.MAGNITUDE);
        try {
            mesh(input);
            return Optional.empty();
        } catch (IllegalArgumentException broken) {
            return Optional.of(Unshown.BROKEN_FACE);
        }
    }

    private static boolean aims(LightSource light) {
        return light.cone().cutoff() != LightSource.white().cone().cutoff();
    }

    /** The body's scene; its light and its finish are the choice's. */
    static Scene scene(String body) {
        Mesh mesh = mesh(input(body));
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

    private static Object input(String body) {
        int slash = body.indexOf('/');
        Topic<?, ?, ?> topic = Named.find("topic", body.substring(0, slash), TOPICS, Topic::name);
        List<Hazard<?>> hazards = List.copyOf(topic.hazards());
        return Named.find("hazard", body.substring(slash + 1), hazards, Hazard::name).input();
    }

    /** The choice that shows an input without an obstacle. */
    static LightChoice shown(String body, Object input, String method) {
        LightChoice first = LightChoice.first().with(new Body(body, Body.COARSEST, Body.OWN));
        if (input instanceof FacePoints points) return face(first, points.face());
        if (input instanceof LitPoints points) return point(first, points.points().get(0), method);
        String normals = Body.NORMALS.contains(method) ? method : "plain";
        return first.with(new Body(body, Body.COARSEST, normals))
                .with(facing((Triangles) input))
                .with(MIDDLE)
                .withArrows(true);
    }

    /** Looks slantingly at the side that most of the surface has; at a closed one, as usual. */
    private static SphericalView facing(Triangles bare) {
        Mesh mesh = body(bare);
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
        double[] middle = middle(face.corners());
        return lit(first, face.material(), face.globalAmbient()[0])
                .withLamp(0, lamp(moved(face.lamp(), middle)))
                .with(camera(moved(face.eye(), middle)))
                .with(MIDDLE);
    }

    private static LightChoice point(LightChoice first, LitPoint point, String method) {
        boolean phong = method.startsWith("phong");
        double[] lamp = Arrays.stream(point.toLight()).map(x -> x * point.distance()).toArray();
        double[] eye = Arrays.stream(point.toEye()).map(x -> x * AWAY).toArray();
        return lit(first, point.material(), point.globalAmbient()[0])
                .with(phong ? Reflection.PHONG : Reflection.BLINN_PHONG)
                .withTwoSides(false)
                .withLamp(0, lamp(lamp))
                .with(camera(eye))
                .with(MIDDLE);
    }

    /** One lamp and a material like that, all of whose shares are grey. */
    private static LightChoice lit(LightChoice first, SurfaceMaterial like, double ambient) {
        Substance grey = Substance.SILVER;
        SurfaceMaterial whole = grey.surface();
        var material =
                new MaterialChoice(
                        grey,
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

    private static Mesh mesh(Object input) {
        if (input instanceof FacePoints points) {
            LitFace face = points.face();
            return triangle(moved(face.corners(), middle(face.corners())), face.normals());
        }
        if (input instanceof LitPoints points) {
            double[] corners = {-PATCH, -PATCH, 0, 2 * PATCH, -PATCH, 0, -PATCH, 2 * PATCH, 0};
            double[] n = points.points().get(0).normal();
            return triangle(
                    corners,
                    IntStream.range(0, corners.length).mapToDouble(i -> n[i % 3]).toArray());
        }
        return body((Triangles) input);
    }

    private static Mesh triangle(double[] corners, double[] normals) {
        var unit = new double[normals.length];
        for (int i = 0; i < normals.length; i += 3) {
            var one = new Vector3d(normals[i], normals[i + 1], normals[i + 2]).normalize();
            unit[i] = one.x;
            unit[i + 1] = one.y;
            unit[i + 2] = one.z;
        }
        return new Mesh(corners, new int[][] {{0, 1, 2}}).withNormals(unit);
    }

    /** Made larger by a power of two, which changes no normal. */
    private static Mesh body(Triangles bare) {
        double[] xyz = moved(bare.vertices(), middle(bare.vertices()));
        double factor = Math.scalb(1, Math.getExponent(REACH / largest(xyz)));
        int[] corners = bare.triangles();
        var faces = new int[corners.length / 3][];
        for (int f = 0; f < faces.length; f++)
            faces[f] = Arrays.copyOfRange(corners, 3 * f, 3 * f + 3);
        return new Mesh(Arrays.stream(xyz).map(x -> x * factor).toArray(), faces);
    }

    private static double largest(double[] xyz) {
        return Arrays.stream(xyz).map(Math::abs).max().orElse(0);
    }

    private static double[] middle(double[] xyz) {
        var middle = new double[3];
        for (int i = 0; i < xyz.length; i++) middle[i % 3] += xyz[i] / (xyz.length / 3);
        return middle;
    }

    private static double[] moved(double[] xyz, double[] middle) {
        var moved = new double[xyz.length];
        for (int i = 0; i < xyz.length; i++) moved[i] = xyz[i] - middle[i % 3];
        return moved;
    }
}
