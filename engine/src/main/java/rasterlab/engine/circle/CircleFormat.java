package rasterlab.engine.circle;

import java.util.List;
import rasterlab.contract.CircleRasterizer;
import rasterlab.engine.format.Field;
import rasterlab.engine.format.FieldKind;
import rasterlab.engine.format.Given;
import rasterlab.engine.format.Shape;
import rasterlab.engine.format.Written;
import rasterlab.engine.raster.AnsweredPixels;
import rasterlab.engine.study.Call;

/** Circles from outside: {@code center}, {@code radius}; {@code pixels} out. */
final class CircleFormat extends ArcFormat<CircleRasterizer, Circle> {
    private static final Field<Integer> RADIUS =
            Field.required("radius", Shape.whole(0, Integer.MAX_VALUE))
                    .as(FieldKind.RADIUS)
                    .in("pixels");

    CircleFormat(CircleTopic topic) {
        super(topic, new AnsweredPixels.FigureName("circle", "give a smaller \"radius\""));
    }

    @Override
    public List<Field<?>> input() {
        return List.of(CENTER, RADIUS);
    }

    @Override
    public String reads() {
        return """
            {"center":[x,y], "radius":r}""";
    }

    @Override
    public Circle read(Given given) {
        int[] center = given.get(CENTER);
        return new Circle(center[0], center[1], given.get(RADIUS));
    }

    @Override
    protected Given given(Circle c) {
        return new Given()
                .with(CENTER, new int[] {c.centerX(), c.centerY()})
                .with(RADIUS, c.radius());
    }

    @Override
    long mostPixels(Circle c) {
        return 8L * c.radius() + 8;
    }

    @Override
    protected Written steps(Call<CircleRasterizer> call, Circle c) {
        SteppedCircle stepped = call.stepped(SteppedCircle.class);
        return walked(stepped.decisionFormula(), stepped.walk(c.radius()));
    }
}
