package rasterlab.engine.visibility.hidden;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import rasterlab.engine.format.Field;
import rasterlab.engine.format.Given;
import rasterlab.engine.format.OpenShape;
import rasterlab.engine.format.RecordedSteps;
import rasterlab.engine.format.Shape;
import rasterlab.engine.format.ValueSink;
import rasterlab.engine.format.Written;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.scene.VertexNumbers;
import rasterlab.engine.study.Call;
import rasterlab.engine.study.Format;
import rasterlab.engine.study.Topic;
import rasterlab.engine.transform.PictureFit;
import rasterlab.engine.transform.Projection;
import rasterlab.engine.transform.SphericalView;
import rasterlab.engine.visibility.SteppedVisibility;
import rasterlab.engine.visibility.Visibility;
import rasterlab.engine.visibility.VisibilityStep;
import rasterlab.engine.visibility.VisibilityWork;

/** Faces drawn from outside: a mesh and how it is seen; {@code picture} out. */
final class HiddenSurfacesFormat extends Format<Visibility, SurfaceView, FacePicture> {
    private static final double LARGEST_SCALE = 1e9;
    private static final Shape<Integer> NUMBER = Shape.whole(-1, Integer.MAX_VALUE);
    private static final Field<double[]> VERTICES =
            Field.required("vertices", Shape.points(3, 0, Shape.MOST_POINTS));
    private static final Field<Double> THETA =
            Field.required("theta", Shape.number()).in("degrees");
    private static final Field<Double> PHI = Field.required("phi", Shape.number()).in("degrees");
    private static final Field<Double> RHO =
            Field.required("rho", Shape.number(SphericalView.NEAREST, SphericalView.FARTHEST));
    private static final Field<List<Integer>> SIZE =
            Field.required(
                            "size",
                            Shape.list("whole numbers", Shape.whole(1, Raster.LARGEST_SIDE), 2, 2))
                    .in("pixels");
    private static final Field<String> PROJECTION =
            Field.optional("projection", Shape.word(Projection.names()));
    private static final Field<Double> SCALE =
            Field.optional("scale", Shape.numberAbove(0, LARGEST_SCALE));
    private static final Field<?> PICTURE =
            Field.required("picture", Shape.list(Shape.list(NUMBER)));
    private static final Field<?> SPLITS = Field.required("splits", NUMBER);
    private static final Field<?> WORK = Field.required("work", new Counts());

    HiddenSurfacesFormat(Topic<Visibility, SurfaceView, FacePicture> topic) {
        super(topic);
    }

    /** Counts by names that each method has of its own. */
    private static final class Counts extends OpenShape {
        @Override
        public void schema(ValueSink out) throws IOException {
            out.startObject();
            out.text("type", "object");
            out.name("additionalProperties");
            out.startObject();
            out.text("type", "integer");
            out.endObject();
            out.endObject();
        }
    }

    @Override
    public List<Field<?>> input() {
        return List.of(VERTICES, VertexNumbers.FACES, THETA, PHI, RHO, SIZE, PROJECTION, SCALE);
    }

    @Override
    public List<Field<?>> answer() {
        return List.of(PICTURE, SPLITS, WORK);
    }

    @Override
    public String reads() {
        return """
            {"vertices":[[x,y,z],...], "faces":[[i,j,k,...],...], vertex numbers from 0, \
            flat, convex and counter-clockwise seen from outside, "theta":a, "phi":b, \
            "rho":r, angles in degrees, "size":[w,h]} and perhaps "projection":NAME, else \
            perspective, and "scale":pixels per unit, else 1""";
    }

    @Override
    public String answers() {
        return """
            {"picture":[[f,...],...] rows of face numbers, -1 where there is none, \
            "splits":n, "work":{"comparisons":n,...}}""";
    }

    @Override
    public SurfaceView read(Given given) {
        List<Integer> size = given.get(SIZE);
        double[] xyz = given.get(VERTICES);
        int[][] faces = given.get(VertexNumbers.FACES).toArray(int[][]::new);
        VertexNumbers.require(faces, xyz.length / 3);
        try {
            var mesh = new Mesh(xyz, faces);
            var camera =
                    new SphericalView(
                            Math.toRadians(given.get(THETA)),
                            Math.toRadians(given.get(PHI)),
                            given.get(RHO));
            return SurfaceView.of(
                    mesh,
                    camera,
                    given.find(PROJECTION).map(Projection::named).orElse(Projection.PERSPECTIVE),
                    new PictureFit(size.get(0), size.get(1), given.get(SCALE, 1.0)));
        } catch (IllegalArgumentException e) {
            throw VertexNumbers.invalid(e);
        }
    }

    @Override
    protected Given given(SurfaceView seen) {
        PictureFit fit = seen.view().fit();
        if (fit.eyeX() != 0 || !Double.isInfinite(seen.view().far()))
            throw new IllegalArgumentException("one eye is told, which sees without end");
        return new Given()
                .with(VERTICES, vertices(seen.mesh()))
                .with(VertexNumbers.FACES, faces(seen.mesh()))
                .with(THETA, degrees(seen.camera().thetaRadians()))
                .with(PHI, degrees(seen.camera().phiRadians()))
                .with(RHO, seen.camera().rho())
                .with(SIZE, List.of(fit.width(), fit.height()))
                .with(PROJECTION, seen.view().transform().projection().code())
                .with(SCALE, fit.pixelsPerUnit());
    }

    /** The degrees whose radians are nearest; not all radians have degrees of their own. */
    private static double degrees(double radians) {
        double degrees = Math.toDegrees(radians);
        for (double near : new double[] {degrees, Math.nextUp(degrees), Math.nextDown(degrees)})
            if (Math.toRadians(near) == radians) return near;
        return degrees;
    }

    private static double[] vertices(Mesh mesh) {
        var xyz = new double[3 * mesh.vertexCount()];
        for (int v = 0; v < mesh.vertexCount(); v++) {
            xyz[3 * v] = mesh.x(v);
            xyz[3 * v + 1] = mesh.y(v);
            xyz[3 * v + 2] = mesh.z(v);
        }
        return xyz;
    }

    private static List<int[]> faces(Mesh mesh) {
        var faces = new ArrayList<int[]>();
        for (int f = 0; f < mesh.faceCount(); f++) {
            int face = f;
            faces.add(
                    IntStream.range(0, mesh.cornerCount(f))
                            .map(k -> mesh.corner(face, k))
                            .toArray());
        }
        return faces;
    }

    @Override
    public void write(SurfaceView input, FacePicture picture, ValueSink out) throws IOException {
        out.name(PICTURE.name());
        out.startArray();
        for (int y = 0; y < picture.height(); y++) {
            out.startArray();
            for (int x = 0; x < picture.width(); x++) out.whole(picture.face(x, y));
            out.endArray();
        }
        out.endArray();
    }

    private Written answer(SurfaceView view, DrawnFaces drawn, Written steps) {
        return answer(view, drawn.picture(), out -> write(drawn.work(), out), steps);
    }

    private static void write(VisibilityWork work, ValueSink out) throws IOException {
        out.whole(SPLITS.name(), work.splits());
        out.name(WORK.name());
        out.startObject();
        for (Map.Entry<String, Long> counted : work.operations().entrySet())
            out.whole(counted.getKey().replace(' ', '-'), counted.getValue());
        out.endObject();
    }

    @Override
    protected void check(Call<Visibility> call, SurfaceView view) {
        if (call.steps()) call.stepped(SteppedVisibility.class);
    }

    @Override
    protected Written answered(Call<Visibility> call, SurfaceView view) {
        if (!call.steps()) return answer(view, DrawnFaces.by(call.method(), view), null);
        SteppedVisibility stepped = call.stepped(SteppedVisibility.class);
        var all = new ArrayList<Step>();
        DrawnFaces drawn =
                DrawnFaces.watched(stepped, view, step -> RecordedSteps.add(all, new Step(step)));
        return answer(view, drawn, RecordedSteps.deciding(stepped.decision(), all));
    }

    /** The next thing that a method did. */
    private record Step(VisibilityStep step) implements Written {
        @Override
        public void write(ValueSink out) throws IOException {
            if (step instanceof VisibilityStep.FaceDrawn drawn) {
                out.whole("draw", drawn.face());
            } else if (step instanceof VisibilityStep.FaceMoved moved) {
                out.whole("move", moved.face());
                out.whole("before", moved.before());
            } else if (step instanceof VisibilityStep.FaceCut cut) {
                out.whole("cut", cut.face());
                out.whole("by", cut.by());
            } else if (step instanceof VisibilityStep.SpanSeen span) {
                out.whole("span", span.face());
                out.whole("y", span.y());
                out.whole("from", span.from());
                out.whole("to", span.to());
            } else if (step instanceof VisibilityStep.Window window) {
                out.wholes("window", window.x(), window.y(), window.width(), window.height());
                out.flag("divided", window.divided());
            }
            out.number("decision", step.value());
        }
    }
}
