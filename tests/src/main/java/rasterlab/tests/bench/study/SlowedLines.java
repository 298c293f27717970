package rasterlab.tests.bench.study;

import java.util.List;
import rasterlab.contract.LineRasterizer;
import rasterlab.engine.line.LineTopic;
import rasterlab.engine.line.Segment;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.study.ForwardingTopic;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Mutant;

/** One method of the topic of segments, and the same one that draws each fifth segment twice. */
final class SlowedLines extends ForwardingTopic<LineRasterizer, Segment, PixelRecording> {
    /** Name of the slowed method. */
    static final String SLOWED = "slowed";

    /** Each of so many calls is made twice: 20 % more work. */
    private static final int EACH = 5;

    private final Method<LineRasterizer> usual;
    private final Method<LineRasterizer> slowed;
    private int calls;

    /**
     * @param method of that topic
     */
    SlowedLines(String method) {
        super(new LineTopic());
        usual = new LineTopic().method(method);
        slowed = Method.right(SLOWED, usual.implementation()::draw);
    }

    @Override
    public List<Method<LineRasterizer>> methods() {
        return List.of(usual, slowed);
    }

    @Override
    public List<Mutant<LineRasterizer>> mutants() {
        return List.of();
    }

    @Override
    public List<Mutant<LineRasterizer>> mutants(String method) {
        return List.of();
    }

    /** The second drawing takes its time and counts for nothing. */
    @Override
    public long spend(LineRasterizer method, Segment input) {
        LineRasterizer real = usual.implementation();
        if (method == slowed.implementation() && ++calls % EACH == 0) super.spend(real, input);
        return super.spend(real, input);
    }
}
