package rasterlab.engine.light.normals;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import rasterlab.contract.VertexNormals;
import rasterlab.engine.format.Field;
import rasterlab.engine.format.Given;
import rasterlab.engine.format.RecordedSteps;
import rasterlab.engine.format.Shape;
import rasterlab.engine.format.ValueSink;
import rasterlab.engine.format.Written;
import rasterlab.engine.study.Call;
import rasterlab.engine.study.Format;
import rasterlab.engine.study.Topic;
import rasterlab.engine.transform.Images;

/** Normals of vertices from outside: {@code vertices}, {@code triangles}; {@code normals} out. */
final class NormalsFormat extends Format<VertexNormals, TriangleSurface, Images> {
    /** The most corners whose steps one answer has. */
    private static final int MOST_STEPPED = 300_000;

    private static final Shape<int[]> CORNERS =
            Shape.described(
                    Shape.wholes(3),
                    Shape.list("vertices", Shape.whole(0, Integer.MAX_VALUE), 3, 3));
    private static final Field<double[]> VERTICES =
            Field.required(
                    "vertices",
                    Shape.described(
                            Shape.points(3, 0, Shape.MOST_POINTS),
                            Shape.list(
                                    "points",
                                    Shape.boundedNumbers(
                                            3, -VertexNormals.LARGEST, VertexNormals.LARGEST),
                                    0,
                                    Shape.MOST_POINTS)));
    private static final Field<List<int[]>> TRIANGLES =
            Field.required("triangles", Shape.list("triangles", CORNERS, 0, Shape.MOST_POINTS));
    private static final Field<?> NORMALS =
            Field.required("normals", Shape.list(Shape.numbersOrNull(3, 3)));

    NormalsFormat(Topic<VertexNormals, TriangleSurface, Images> topic) {
        super(topic);
    }

    @Override
    public List<Field<?>> input() {
        return List.of(VERTICES, TRIANGLES);
    }

    @Override
    public List<Field<?>> answer() {
        return List.of(NORMALS);
    }

    @Override
    public String reads() {
        return """
            {"vertices":[[x,y,z],...], "triangles":[[i,j,k],...]}, vertex numbers from 0, \
            counter-clockwise seen from outside""";
    }

    @Override
    public String answers() {
        return """
            {"normals":[[x,y,z],...]}, [0,0,0] where there is none""";
    }

    @Override
    public TriangleSurface read(Given given) {
        int[] corners = given.get(TRIANGLES).stream().flatMapToInt(Arrays::stream).toArray();
        try {
            return new TriangleSurface(given.get(VERTICES), corners);
        } catch (IllegalArgumentException e) {
            throw given.invalid(e);
        }
    }

    @Override
    protected Given given(TriangleSurface surface) {
        return new Given()
                .with(VERTICES, surface.vertices())
                .with(
                        TRIANGLES,
                        Stream.iterate(0, i -> i < surface.triangles().length, i -> i + 3)
                                .map(i -> Arrays.copyOfRange(surface.triangles(), i, i + 3))
                                .toList());
    }

    @Override
    public void write(TriangleSurface input, Images images, ValueSink out) throws IOException {
        out.points(NORMALS.name(), images.coordinates(), 3);
    }

    @Override
    protected void check(Call<VertexNormals> call, TriangleSurface surface) {
        if (!call.steps()) return;
        call.stepped(SteppedNormals.class);
        RecordedSteps.requireAtMost(
                MOST_STEPPED, "corners of triangles", surface.triangles().length);
    }

    /** A face's normal added to a vertex's sum. */
    private record Step(int face, int vertex, double weight, double[] sum) implements Written {
        @Override
        public void write(ValueSink out) throws IOException {
            out.whole("face", face);
            out.whole("vertex", vertex);
            out.number("decision", weight);
            out.numbers("sum", sum);
        }
    }

    /** {@inheritDoc} With steps the normals are those of the walk. */
    @Override
    protected Written answered(Call<VertexNormals> call, TriangleSurface surface) {
        if (!call.steps()) return super.answered(call, surface);
        SteppedNormals stepped = call.stepped(SteppedNormals.class);
        NormalsWalk walk = stepped.walk(surface.vertices(), surface.triangles());
        var steps = new ArrayList<Step>();
        while (walk.advance())
            steps.add(new Step(walk.face(), walk.vertex(), walk.weight(), walk.sum()));
        return answer(
                surface,
                new Images(walk.normals(), 3),
                null,
                RecordedSteps.deciding(stepped.weightFormula(), steps));
    }
}
