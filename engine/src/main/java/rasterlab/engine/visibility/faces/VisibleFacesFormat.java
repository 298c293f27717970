package rasterlab.engine.visibility.faces;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import rasterlab.contract.VisibleFaces;
import rasterlab.engine.format.Field;
import rasterlab.engine.format.Given;
import rasterlab.engine.format.RecordedSteps;
import rasterlab.engine.format.Shape;
import rasterlab.engine.format.ValueSink;
import rasterlab.engine.format.Written;
import rasterlab.engine.scene.VertexNumbers;
import rasterlab.engine.study.Call;
import rasterlab.engine.study.Format;
import rasterlab.engine.study.Topic;

/** Faces turned to the eye from outside: a body and the eye; {@code visible} out. */
final class VisibleFacesFormat extends Format<VisibleFaces, Body, SeenFaces> {
    private static final Field<double[]> VERTICES =
            Field.required("vertices", Shape.points(3, 0, Shape.MOST_POINTS));
    private static final Field<List<int[]>> FACES = VertexNumbers.FACES;
    private static final Field<double[]> EYE = Field.required("eye", Shape.numbers(3, 3));
    private static final Field<double[]> INSIDE = Field.optional("inside", Shape.numbers(3, 3));
    private static final Field<?> VISIBLE = Field.required("visible", Shape.list(Shape.flag()));

    VisibleFacesFormat(Topic<VisibleFaces, Body, SeenFaces> topic) {
        super(topic);
    }

    @Override
    public List<Field<?>> input() {
        return List.of(VERTICES, FACES, EYE, INSIDE);
    }

    @Override
    public List<Field<?>> answer() {
        return List.of(VISIBLE);
    }

    @Override
    public String reads() {
        return """
            {"vertices":[[x,y,z],...], "faces":[[i,j,k,...],...], vertex numbers from 0, \
            counter-clockwise seen from outside, "eye":[x,y,z]} and perhaps \
            "inside":[x,y,z], an inner point, else the mean of the vertices""";
    }

    @Override
    public String answers() {
        return """
            {"visible":[true,...]}, whether each face is turned towards the eye""";
    }

    @Override
    public Body read(Given given) {
        int[][] faces = given.get(FACES).toArray(int[][]::new);
        double[] xyz = given.get(VERTICES);
        VertexNumbers.require(faces, xyz.length / 3);
        return new Body(xyz, faces, given.get(EYE), given.get(INSIDE, new double[0]));
    }

    @Override
    protected Given given(Body body) {
        Given given =
                new Given()
                        .with(VERTICES, body.xyz())
                        .with(FACES, List.of(body.faces()))
                        .with(EYE, body.eye());
        return body.inside().length == 0 ? given : given.with(INSIDE, body.inside());
    }

    @Override
    public void write(Body input, SeenFaces seen, ValueSink out) throws IOException {
        out.name(VISIBLE.name());
        out.startArray();
        for (int f = 0; f < seen.size(); f++) out.flag(seen.visible(f));
        out.endArray();
    }

    /** One face as the walk judged it. */
    private record Judged(int face, boolean visible, double value) implements Written {
        @Override
        public void write(ValueSink out) throws IOException {
            out.whole("face", face);
            out.number("decision", value);
            out.flag("visible", visible);
        }
    }

    @Override
    protected void check(Call<VisibleFaces> call, Body body) {
        if (call.steps()) call.stepped(SteppedVisibleFaces.class);
    }

    /** {@inheritDoc} With steps the faces are as the walk judged them. */
    @Override
    protected Written answered(Call<VisibleFaces> call, Body body) {
        if (!call.steps()) return super.answered(call, body);
        SteppedVisibleFaces stepped = call.stepped(SteppedVisibleFaces.class);
        FaceWalk walk = stepped.walk(body);
        var all = new ArrayList<Judged>();
        while (walk.advance()) all.add(new Judged(walk.face(), walk.visible(), walk.value()));
        return out -> {
            out.name(VISIBLE.name());
            out.startArray();
            for (Judged each : all) out.flag(each.visible);
            out.endArray();
            RecordedSteps.deciding(stepped.decision(), all).write(out);
        };
    }
}
