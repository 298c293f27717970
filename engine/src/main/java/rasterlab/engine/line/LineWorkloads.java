package rasterlab.engine.line;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import rasterlab.engine.study.Workload;

/** Segments to measure: of one length each, in all eight octants, the same in every run. */
final class LineWorkloads {
    private static final long SEED = 1965;
    private static final int PIXELS_PER_WORKLOAD = 8_192;
    private static final int FEWEST_SEGMENTS = 16;

    private LineWorkloads() {}

    static List<Workload<Segment>> all() {
        return List.of(pixels(16), pixels(64), pixels(256), pixels(1024), pixels(4096));
    }

    private static Workload<Segment> pixels(int size) {
        var random = new Random(SEED + size);
        int count = Math.max(FEWEST_SEGMENTS, PIXELS_PER_WORKLOAD / size);
        var segments = new ArrayList<Segment>();
        for (int i = 0; i < count; i++) segments.add(inOctant(i % 8, size - 1, random));
        return new Workload<>("length-" + size, size, segments);
    }

    private static Segment inOctant(int octant, int steps, Random random) {
        int across = random.nextInt(steps + 1);
        boolean steep = (octant & 1) != 0;
        int dx = (octant & 2) != 0 ? -1 : 1;
        int dy = (octant & 4) != 0 ? -1 : 1;
        dx *= steep ? across : steps;
        dy *= steep ? steps : across;
        int x = random.nextInt(1000);
        int y = random.nextInt(1000);
        return new Segment(x, y, x + dx, y + dy);
    }
}
