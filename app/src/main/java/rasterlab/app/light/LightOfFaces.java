package rasterlab.app.light;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.BooleanSupplier;
import rasterlab.app.mine.OwnMethods;
import rasterlab.contract.FaceShader;
import rasterlab.contract.LitFace;
import rasterlab.engine.light.Light;
import rasterlab.engine.light.face.FaceTopic;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.study.WrongLength;
import rasterlab.engine.transform.ViewTransform;
import rasterlab.engine.visibility.SeenPoint;

/**
 * Light by methods of topic {@code shade-face}, which are asked once for all points of a triangle
 * and each lamp.
 */
public record LightOfFaces(LightChoice choice, Mesh mesh, ViewTransform transform)
        implements LightAtPoints {
    public static final String TOPIC = new FaceTopic().name();

    private static final int MOST_POINTS = 6000;

    /** The tolerance of light where the program's exercise gives none: the topic's own. */
    private static final String USUAL = "phong";

    /** A triangle of the fan of a face, seen from one side. */
    private record Part(int face, int fan, boolean behind) {}

    @Override
    public int most() {
        return MOST_POINTS;
    }

    @Override
    public double[] right(OwnMethods own, List<SeenPoint> points, BooleanSupplier cancelled) {
        String truth =
                own.of(TOPIC)
                        .flatMap(program -> program.exercise().tolerance().truth())
                        .orElse(USUAL);
        return light(new FaceTopic().method(truth).implementation(), points, cancelled);
    }

    @Override
    public double[] by(OwnMethods own, List<SeenPoint> points, BooleanSupplier cancelled) {
        FaceShader program = own.in(new FaceTopic()).method(OwnMethods.NAME).implementation();
        return light(program, points, cancelled);
    }

    private double[] light(FaceShader method, List<SeenPoint> points, BooleanSupplier cancelled) {
        Map<Part, List<Integer>> parts = new LinkedHashMap<>();
        for (int k = 0; k < points.size(); k++) {
            SeenPoint at = points.get(k);
            parts.computeIfAbsent(
                            new Part(at.face(), at.fan(), at.behind()), part -> new ArrayList<>())
                    .add(k);
        }
        var light = new double[3 * points.size()];
        parts.forEach((part, of) -> add(method, part, of, points, light, cancelled));
        return light;
    }

    private void add(
            FaceShader method,
            Part part,
            List<Integer> of,
            List<SeenPoint> points,
            double[] light,
            BooleanSupplier cancelled) {
        boolean turned = choice.twoSided() && part.behind();
        var weights = new double[3 * of.size()];
        for (int i = 0; i < of.size(); i++) {
            double[] three = points.get(of.get(i)).weights();
            for (int c = 0; c < 3; c++) weights[3 * i + c] = three[corner(c, turned)];
        }
        List<Lamp> lamps = LightAtPoints.shining(choice);
        for (int lamp = 0; lamp < lamps.size(); lamp++) {
            LightAtPoints.check(cancelled);
            double[] shares = method.shade(lit(part, turned, lamps.get(lamp), lamp), weights);
            WrongLength.require(weights.length, shares.length, "shares");
            for (int i = 0; i < of.size(); i++)
                for (int c = 0; c < 3; c++) light[3 * of.get(i) + c] += shares[3 * i + c];
        }
    }

    /** Corners of a triangle seen from behind go round the other way. */
    private static int corner(int corner, boolean turned) {
        return turned ? (3 - corner) % 3 : corner;
    }

    private LitFace lit(Part part, boolean turned, Lamp lamp, int number) {
        int[] three = {0, part.fan(), part.fan() + 1};
        var corners = new double[9];
        var normals = new double[9];
        for (int k = 0; k < 3; k++) {
            int of = three[corner(k, turned)];
            int v = mesh.corner(part.face(), of);
            corners[3 * k] = mesh.x(v);
            corners[3 * k + 1] = mesh.y(v);
            corners[3 * k + 2] = mesh.z(v);
            for (int axis = 0; axis < 3; axis++)
                normals[3 * k + axis] =
                        (turned ? -1 : 1) * mesh.cornerNormal(part.face(), of, axis);
        }
        return new LitFace(
                corners,
                normals,
                place(lamp),
                eye(),
                LightAtPoints.material(choice, number),
                LightAtPoints.source(lamp),
                LightAtPoints.globalAmbient(choice, number));
    }

    private static double[] place(Lamp lamp) {
        Light light = lamp.light();
        double away = light.directional() ? FAR : 1;
        return new double[] {away * light.x(), away * light.y(), away * light.z()};
    }

    private double[] eye() {
        double[] toEye = PointReading.toEye(choice, transform, new double[3]);
        double away = choice.localViewer() ? 1 : FAR;
        for (int c = 0; c < 3; c++) toEye[c] *= away;
        return toEye;
    }
}
