package rasterlab.engine.clip.volume;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import rasterlab.engine.study.Workload;

/**
 * A hundred segments around the view volume, of which a given number is visible, the same in every
 * run. The others lie beyond one plane or pass behind the eye.
 */
final class VolumeClipWorkloads {
    private static final long SEED = 1978;
    private static final int SEGMENTS = 100;
    private static final int INPUTS = 10;
    private static final double ZMIN = 0.1;

    private VolumeClipWorkloads() {}

    static List<Workload<SegmentsInVolume>> all() {
        return IntStream.of(5, 25, 50, 75, 95).mapToObj(VolumeClipWorkloads::visible).toList();
    }

    private static Workload<SegmentsInVolume> visible(int visible) {
        var random = new Random(SEED + visible);
        var inputs = new ArrayList<SegmentsInVolume>();
        for (int i = 0; i < INPUTS; i++) inputs.add(input(visible, random));
        return new Workload<>("visible-" + visible, visible, inputs);
    }

    private static SegmentsInVolume input(int visible, Random random) {
        var segments = new ArrayList<double[]>();
        for (int i = 0; i < SEGMENTS; i++)
            segments.add(i < visible ? through(random) : beyond(i % 4, random));
        Collections.shuffle(segments, random);
        return new SegmentsInVolume(ZMIN, segments);
    }

    private static double[] through(Random random) {
        double z = ZMIN + (1 - ZMIN) * random.nextDouble();
        double x = z * (2 * random.nextDouble() - 1);
        double y = z * (2 * random.nextDouble() - 1);
        double dx = 2 * random.nextDouble() - 1;
        double dy = 2 * random.nextDouble() - 1;
        double dz = 2 * random.nextDouble() - 1;
        double back = random.nextDouble();
        double on = random.nextDouble();
        return new double[] {
            x - back * dx, y - back * dy, z - back * dz, x + on * dx, y + on * dy, z + on * dz
        };
    }

    private static double[] beyond(int plane, Random random) {
        double[] s = new double[6];
        for (int end = 0; end < 6; end += 3) {
            double z = 3 * random.nextDouble() - 1;
            double other = 3 * random.nextDouble() - 1.5;
            double outside = Math.max(z, 0) + 0.01 + random.nextDouble();
            s[end] = plane == 0 ? outside : other;
            s[end + 1] = plane == 1 ? -outside : other;
            s[end + 2] =
                    plane == 2 ? ZMIN - 0.01 - random.nextDouble() : plane == 3 ? 1 + outside : z;
        }
        return s;
    }
}
