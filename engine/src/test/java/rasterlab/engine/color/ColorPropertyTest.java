package rasterlab.engine.color;

import static org.junit.jupiter.api.Assertions.assertTrue;

import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.Tag;
import rasterlab.contract.ColorModel;
import rasterlab.engine.study.Deviation;

@Tag("slow")
class ColorPropertyTest {
    private static final ColorTopic TOPIC = new ColorTopic();

    @Provide
    Arbitrary<Colors> colors() {
        return Arbitraries.of(ColorModel.values())
                .flatMap(
                        model ->
                                Arbitraries.doubles()
                                        .between(0, 1)
                                        .ofScale(20)
                                        .array(double[].class)
                                        .ofSize(model.size())
                                        .map(shares -> fitted(model, shares)));
    }

    /** Numbers from 0 to 1 stretched to the model's ranges. */
    private static Colors fitted(ColorModel model, double[] shares) {
        for (int i = 0; i < shares.length; i++)
            shares[i] = Math.min(shares[i], 1) * model.highest(i);
        return new Colors(model, shares);
    }

    @Property(tries = 2000)
    void formulaIsExactOrOutsideTheCube(@ForAll("colors") Colors colors) {
        ColorSheet actual;
        try {
            actual = TOPIC.record(new FormulaColors(), colors, 1);
        } catch (IllegalArgumentException refusal) {
            assertTrue(colors.model() == ColorModel.HVS, refusal.getMessage());
            return;
        }
        Deviation deviation = TOPIC.compare(colors, TOPIC.exact(colors, 1), actual);
        assertTrue(TOPIC.correct(deviation), () -> colors + " " + deviation);
    }
}
