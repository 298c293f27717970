package rasterlab.engine.light.face;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import rasterlab.contract.FaceShader;
import rasterlab.contract.LitFace;
import rasterlab.engine.format.Field;
import rasterlab.engine.format.Given;
import rasterlab.engine.format.RecordedSteps;
import rasterlab.engine.format.Shape;
import rasterlab.engine.format.ValueSink;
import rasterlab.engine.format.Written;
import rasterlab.engine.light.LightFormat;
import rasterlab.engine.study.Call;
import rasterlab.engine.study.Format;
import rasterlab.engine.study.Topic;

/** Shaded faces from outside: a lit triangle and points of it; {@code intensity} of each out. */
final class FaceFormat extends Format<FaceShader, FacePoints, double[]> {
    private static final Shape<double[]> WITHIN =
            Shape.boundedNumbers(3, -LitFace.LARGEST, LitFace.LARGEST);
    private static final Field<double[]> CORNERS = three("corners");
    private static final Field<double[]> NORMALS = three("normals");
    private static final Field<double[]> LAMP = vector("lamp");
    private static final Field<double[]> EYE = vector("eye");
    private static final Field<double[]> POINTS =
            Field.required("points", Shape.points(3, 0, Shape.MOST_POINTS));
    private static final Field<?> INTENSITY =
            Field.required("intensity", Shape.list(Shape.numbersOrNull(3, 3)));

    FaceFormat(Topic<FaceShader, FacePoints, double[]> topic) {
        super(topic);
    }

    private static Field<double[]> three(String name) {
        Shape<?> told = Shape.list("points", WITHIN, 3, 3);
        return Field.required(name, Shape.described(Shape.points(3, 3, 3), told));
    }

    private static Field<double[]> vector(String name) {
        return Field.required(name, WITHIN);
    }

    @Override
    public List<Field<?>> input() {
        return List.of(
                CORNERS,
                NORMALS,
                LAMP,
                EYE,
                LightFormat.MATERIAL,
                LightFormat.LIGHT,
                LightFormat.GLOBAL_AMBIENT,
                POINTS);
    }

    @Override
    public List<Field<?>> answer() {
        return List.of(INTENSITY);
    }

    @Override
    public String reads() {
        return """
            {"corners":[[x,y,z],[x,y,z],[x,y,z]], "normals":[[x,y,z],...], "lamp":[x,y,z], \
            "eye":[x,y,z], "material":M, "light":L, "global-ambient":C, "points":[[a,b,c],...]}, \
            a point by its shares of the corners, light and global-ambient being optional;"""
                + " "
                + LightFormat.WORDS;
    }

    @Override
    public String answers() {
        return """
            {"intensity":[[r,g,b],...]}""";
    }

    @Override
    public FacePoints read(Given given) {
        try {
            var face =
                    new LitFace(
                            given.get(CORNERS),
                            given.get(NORMALS),
                            given.get(LAMP),
                            given.get(EYE),
                            given.get(LightFormat.MATERIAL),
                            LightFormat.light(given),
                            LightFormat.globalAmbient(given));
            return new FacePoints(face, given.get(POINTS));
        } catch (IllegalArgumentException e) {
            throw given.invalid(e);
        }
    }

    @Override
    protected Given given(FacePoints points) {
        LitFace face = points.face();
        return new Given()
                .with(CORNERS, face.corners())
                .with(NORMALS, face.normals())
                .with(LAMP, face.lamp())
                .with(EYE, face.eye())
                .with(LightFormat.MATERIAL, face.material())
                .with(LightFormat.LIGHT, face.light())
                .with(LightFormat.GLOBAL_AMBIENT, face.globalAmbient())
                .with(POINTS, points.weights());
    }

    @Override
    public void write(FacePoints input, double[] shades, ValueSink out) throws IOException {
        out.points(INTENSITY.name(), shades, 3);
    }

    /** The formula once. */
    private record Evaluation(double[] place, double[] normal, double[] intensity)
            implements Written {
        @Override
        public void write(ValueSink out) throws IOException {
            out.text("step", "formula");
            out.numbers("place", place);
            out.numbers("normal", normal);
            out.numbers("intensity", intensity);
        }
    }

    @Override
    protected Written steps(Call<FaceShader> call, FacePoints points) {
        SteppedFace stepped = call.stepped(SteppedFace.class);
        List<Evaluation> all = new ArrayList<>();
        stepped.shade(
                points.face(),
                points.weights(),
                (place, normal, intensity) ->
                        RecordedSteps.add(
                                all,
                                new Evaluation(place.clone(), normal.clone(), intensity.clone())));
        return RecordedSteps.plain(all);
    }
}
