package rasterlab.engine.circle;

import java.util.List;
import rasterlab.contract.EllipseRasterizer;
import rasterlab.engine.format.Field;
import rasterlab.engine.format.FieldKind;
import rasterlab.engine.format.Given;
import rasterlab.engine.format.Shape;
import rasterlab.engine.format.Written;
import rasterlab.engine.raster.AnsweredPixels;
import rasterlab.engine.study.Call;

/** Ellipses from outside: {@code center}, {@code rx}, {@code ry}; {@code pixels} out. */
final class EllipseFormat extends ArcFormat<EllipseRasterizer, Ellipse> {
    private static final Field<Integer> RX = radius("rx").as(FieldKind.RADIUS_X);
    private static final Field<Integer> RY = radius("ry").as(FieldKind.RADIUS_Y);

    EllipseFormat(EllipseTopic topic) {
        super(topic, new AnsweredPixels.FigureName("ellipse", "give smaller \"rx\" and \"ry\""));
    }

    /** A field for a radius, in the range that every method takes. */
    private static Field<Integer> radius(String name) {
        return Field.required(name, Shape.whole(0, MidpointEllipse.LARGEST)).in("pixels");
    }

    @Override
    public List<Field<?>> input() {
        return List.of(CENTER, RX, RY);
    }

    @Override
    public String reads() {
        return """
            {"center":[x,y], "rx":a, "ry":b}""";
    }

    @Override
    public Ellipse read(Given given) {
        int[] center = given.get(CENTER);
        return new Ellipse(center[0], center[1], given.get(RX), given.get(RY));
    }

    @Override
    protected Given given(Ellipse e) {
        return new Given()
                .with(CENTER, new int[] {e.centerX(), e.centerY()})
                .with(RX, e.radiusX())
                .with(RY, e.radiusY());
    }

    @Override
    long mostPixels(Ellipse e) {
        return 8L * ((long) e.radiusX() + e.radiusY()) + 8;
    }

    @Override
    protected Written steps(Call<EllipseRasterizer> call, Ellipse e) {
        SteppedEllipse stepped = call.stepped(SteppedEllipse.class);
        return walked(stepped.decisionFormula(), stepped.walk(e.radiusX(), e.radiusY()));
    }
}
