package rasterlab.exercises.graded;

import java.util.Map;
import java.util.function.Supplier;
import rasterlab.contract.PointShader;
import rasterlab.contract.Reflection;
import rasterlab.engine.light.shade.LitPoints;
import rasterlab.engine.light.shade.ShadeTopic;
import rasterlab.engine.light.shade.Shades;
import rasterlab.exercises.judging.Demand;

/**
 * Grades the topic {@code shade}; shows the three shares of each point in a table. The topic's
 * exact answer has all specular terms, of which an answer is held against its own.
 */
public final class ShadeGrading extends ByForm<PointShader, LitPoints, Shades> {
    public ShadeGrading() {
        super(new ShadeTopic());
    }

    @Override
    protected Shades right(LitPoints input, Supplier<Shades> truth, Shades actual, Demand demand) {
        Reflection own = actual.rgb().keySet().iterator().next();
        return new Shades(Map.of(own, truth.get().rgb().get(own)));
    }
}
