package rasterlab.app.light;

import java.util.List;
import java.util.function.BooleanSupplier;
import rasterlab.app.mine.OwnMethods;
import rasterlab.contract.LitPoint;
import rasterlab.contract.PointShader;
import rasterlab.contract.Reflection;
import rasterlab.engine.light.Light;
import rasterlab.engine.light.UnitVector;
import rasterlab.engine.light.shade.FormulaShader;
import rasterlab.engine.light.shade.ShadeTopic;
import rasterlab.engine.study.WrongLength;
import rasterlab.engine.transform.ViewTransform;
import rasterlab.engine.visibility.SeenPoint;

/** Light by methods of topic {@code shade}, which are asked for each point and lamp. */
public record LightOfPoints(LightChoice choice, ViewTransform transform) implements LightAtPoints {
    public static final String TOPIC = new ShadeTopic().name();

    /** Each is a way to another process and back. */
    private static final int MOST_CALLS = 1600;

    @Override
    public int most() {
        return MOST_CALLS / LightAtPoints.shining(choice).size();
    }

    @Override
    public double[] right(OwnMethods own, List<SeenPoint> points, BooleanSupplier cancelled) {
        return light(new FormulaShader(Reflection.PHONG), points, cancelled);
    }

    @Override
    public double[] by(OwnMethods own, List<SeenPoint> points, BooleanSupplier cancelled) {
        PointShader program = own.in(new ShadeTopic()).method(OwnMethods.NAME).implementation();
        return light(program, points, cancelled);
    }

    private double[] light(PointShader method, List<SeenPoint> points, BooleanSupplier cancelled) {
        List<Lamp> lamps = LightAtPoints.shining(choice);
        var light = new double[3 * points.size()];
        for (int k = 0; k < points.size(); k++)
            for (int lamp = 0; lamp < lamps.size(); lamp++) {
                LightAtPoints.check(cancelled);
                double[] one = method.intensity(lit(points.get(k), lamps.get(lamp), lamp));
                WrongLength.require(3, one.length, "shares");
                for (int c = 0; c < 3; c++) light[3 * k + c] += one[c];
            }
        return light;
    }

    private LitPoint lit(SeenPoint seen, Lamp lamp, int number) {
        Light placed = lamp.light();
        double[] point = seen.position();
        double[] toLight = {placed.x(), placed.y(), placed.z()};
        if (!placed.directional()) for (int c = 0; c < 3; c++) toLight[c] -= point[c];
        return new LitPoint(
                PointReading.normal(choice, seen),
                toLight,
                PointReading.toEye(choice, transform, point),
                UnitVector.length(toLight),
                LightAtPoints.material(choice, number),
                LightAtPoints.source(lamp),
                LightAtPoints.globalAmbient(choice, number));
    }
}
