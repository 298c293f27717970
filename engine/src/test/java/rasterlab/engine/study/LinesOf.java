package rasterlab.engine.study;

import java.util.List;
import java.util.Map;
import rasterlab.contract.LineRasterizer;
import rasterlab.engine.line.LineTopic;
import rasterlab.engine.line.Segment;
import rasterlab.engine.raster.PixelRecording;

/** The line topic with methods made up by a test and two small workloads. */
record LinesOf(List<Method<LineRasterizer>> methods)
        implements Topic<LineRasterizer, Segment, PixelRecording> {
    private static final LineTopic LINE = new LineTopic();

    static Method<LineRasterizer> method(String name, LineRasterizer implementation) {
        return Method.failing(name, implementation);
    }

    static Hazard<Segment> hazard(Segment segment) {
        return new Hazard<>("made-up", segment, Map.of());
    }

    @Override
    public String name() {
        return "line";
    }

    @Override
    public String lab() {
        return "line";
    }

    @Override
    public Class<LineRasterizer> contract() {
        return LineRasterizer.class;
    }

    @Override
    public Format<LineRasterizer, Segment, PixelRecording> format() {
        return LINE.format();
    }

    @Override
    public List<Hazard<Segment>> hazards() {
        return List.of(hazard(new Segment(0, 0, 9, 4)));
    }

    @Override
    public List<Workload<Segment>> workloads() {
        return List.of(
                new Workload<>(
                        "short", 4, List.of(new Segment(0, 0, 3, 1), new Segment(0, 0, 3, 2))),
                new Workload<>("long", 10, List.of(new Segment(0, 0, 9, 4))));
    }

    @Override
    public PixelRecording run(LineRasterizer method, Segment input, int limit) {
        return LINE.run(method, input, limit);
    }

    @Override
    public long spend(LineRasterizer method, Segment input) {
        return LINE.spend(method, input);
    }

    @Override
    public Map<String, Long> operations(LineRasterizer method, Segment input) {
        return Map.of("ends", 2L);
    }

    /** A worst error of just 3 pixels, which is none of LINE's, counts as right. */
    @Override
    public boolean correct(Deviation deviation) {
        return deviation.exact() || deviation.worst() == 3;
    }

    @Override
    public PixelRecording exact(Segment input, int limit) {
        return LINE.exact(input, limit);
    }

    /** An answer that is 4 pixels off stands for one that comparing chokes on. */
    @Override
    public Deviation compare(Segment input, PixelRecording exact, PixelRecording actual) {
        if (actual.size() > 0 && actual.y(0) == exact.y(0) + 4)
            throw new IndexOutOfBoundsException("row 4");
        return LINE.compare(input, exact, actual);
    }

    @Override
    public boolean usable(Deviation deviation) {
        return LINE.usable(deviation);
    }

    @Override
    public String item() {
        return LINE.item();
    }

    @Override
    public String errorUnit() {
        return LINE.errorUnit();
    }
}
