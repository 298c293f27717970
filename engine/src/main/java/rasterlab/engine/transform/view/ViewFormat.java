package rasterlab.engine.transform.view;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import rasterlab.contract.EyeView;
import rasterlab.engine.format.Field;
import rasterlab.engine.format.Given;
import rasterlab.engine.format.RecordedSteps;
import rasterlab.engine.format.Shape;
import rasterlab.engine.format.ValueSink;
import rasterlab.engine.format.Written;
import rasterlab.engine.study.Call;
import rasterlab.engine.study.Format;
import rasterlab.engine.study.Topic;
import rasterlab.engine.transform.Coordinates;
import rasterlab.engine.transform.Images;

/** Views from outside: {@code points} and the eye by its angles; {@code points} as seen out. */
public final class ViewFormat extends Format<EyeView, ViewTask, Images> {
    /** The most points whose steps one answer has. */
    private static final int MOST_STEPPED = 100_000;

    private static final Field<double[]> POINTS =
            Field.required("points", Shape.points(3, 0, Shape.MOST_POINTS));
    private static final Field<Double> THETA =
            Field.required("theta", Shape.number()).in("degrees");
    private static final Field<Double> PHI = Field.required("phi", Shape.number()).in("degrees");
    private static final Field<Double> RHO =
            Field.required("rho", Shape.numberAbove(0, Coordinates.LARGEST));
    private static final Field<?> SEEN =
            Field.required("points", Shape.list(Shape.numbersOrNull(3, 3)));

    public ViewFormat(Topic<EyeView, ViewTask, Images> topic) {
        super(topic);
    }

    @Override
    public List<Field<?>> input() {
        return List.of(POINTS, THETA, PHI, RHO);
    }

    @Override
    public List<Field<?>> answer() {
        return List.of(SEEN);
    }

    @Override
    public String reads() {
        return """
            {"points":[[x,y,z],...], "theta":a, "phi":b, "rho":r}""";
    }

    @Override
    public String answers() {
        return """
            {"points":[[x,y,z],...]} in the left-handed space of the eye""";
    }

    @Override
    public ViewTask read(Given given) {
        return new ViewTask(given.get(THETA), given.get(PHI), given.get(RHO), given.get(POINTS));
    }

    @Override
    protected Given given(ViewTask look) {
        return new Given()
                .with(POINTS, look.points())
                .with(THETA, look.theta())
                .with(PHI, look.phi())
                .with(RHO, look.rho());
    }

    @Override
    public void write(ViewTask input, Images images, ValueSink out) throws IOException {
        out.points(SEEN.name(), images.coordinates(), 3);
    }

    @Override
    protected void check(Call<EyeView> call, ViewTask look) {
        if (!call.steps()) return;
        call.stepped(SteppedView.class);
        RecordedSteps.requireAtMost(MOST_STEPPED, "points", look.points().length / 3);
    }

    /** A formula with what it gave. */
    private record Step(ViewStep step) implements Written {
        @Override
        public void write(ValueSink out) throws IOException {
            out.whole("number", step.number());
            out.text("step", step.formula());
            out.number("value", step.value());
        }
    }

    @Override
    protected Written steps(Call<EyeView> call, ViewTask look) {
        SteppedView stepped = call.stepped(SteppedView.class);
        var steps = new ArrayList<List<Step>>();
        double[] p = look.points();
        for (int i = 0; i < p.length; i += 3)
            steps.add(
                    stepped
                            .steps(look.theta(), look.phi(), look.rho(), p[i], p[i + 1], p[i + 2])
                            .stream()
                            .map(Step::new)
                            .toList());
        return RecordedSteps.plainLists(steps);
    }
}
