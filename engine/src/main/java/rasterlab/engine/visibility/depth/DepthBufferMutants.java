package rasterlab.engine.visibility.depth;

import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.UnaryOperator;
import rasterlab.contract.DepthFormat;
import rasterlab.contract.DepthRange;
import rasterlab.engine.study.Mutant;

/** Depths stored with one mistake. */
final class DepthBufferMutants {
    private static final DepthCoding RIGHT = new ReversedDepth();
    private static final int BITS = 24;

    private DepthBufferMutants() {}

    static List<Mutant<DepthFormat>> all() {
        return List.of(
                new Mutant<>("codes-reversed", "far-near-10", over(Turned::new)),
                new Mutant<>("sixteen-bits", "far-near-1000", new FixedDepth(16)),
                new Mutant<>("floats-close-to-the-eye", "far-near-million", new FloatDepth()),
                new Mutant<>("far-plane-limited", "no-far-plane", limited()),
                new Mutant<>("even-in-one-over-z", "near-next-to-the-eye", new FixedDepth(32)),
                new Mutant<>("far-code-overflows", "on-the-planes", wrapped()),
                new Mutant<>("code-changes", "twice-the-same", counted()),
                new Mutant<>("even-in-z", "close-to-the-eye", new LinearDepth(16)),
                new Mutant<>("summed-in-float", "drift-8192", new IncrementalFloat()),
                new Mutant<>("z-linear", "slope-through-a-wall", over(LinearZ::new)));
    }

    private static double least(double far, double most) {
        return far < most ? far : most;
    }

    private static DepthCoding limited() {
        return range -> RIGHT.over(new DepthRange(range.near(), least(range.far(), 1e6)));
    }

    private static DepthCoding wrapped() {
        return Wrapped::new;
    }

    private static DepthCoding counted() {
        var rows = new AtomicInteger();
        return over(right -> new Counted(right, rows));
    }

    private static DepthCoding over(UnaryOperator<DepthCoding.RangeCodes> mistake) {
        return range -> mistake.apply(RIGHT.over(range));
    }

    /** Right codes, each row of which may be changed. */
    private static class Changed implements DepthCoding.RangeCodes {
        final DepthCoding.RangeCodes right;

        Changed(DepthCoding.RangeCodes right) {
            this.right = right;
        }

        @Override
        public int code(double nearness) {
            return right.code(nearness);
        }

        @Override
        public void row(double base, double perPixel, int from, int to, int[] codes) {
            for (int i = from; i < to; i++) codes[i - from] = code(base + i * perPixel);
        }

        @Override
        public double stored(int code) {
            return right.stored(code);
        }

        @Override
        public double depth(int code) {
            return right.depth(code);
        }
    }

    private static final class Turned extends Changed {
        Turned(DepthCoding.RangeCodes right) {
            super(right);
        }

        @Override
        public int code(double nearness) {
            return -right.code(nearness);
        }

        @Override
        public double stored(int code) {
            return right.stored(-code);
        }

        @Override
        public double depth(int code) {
            return right.depth(-code);
        }
    }

    private static final class Wrapped extends Changed {
        Wrapped(DepthRange range) {
            super(new FixedDepth(BITS).over(range));
        }

        @Override
        public int code(double nearness) {
            return (right.code(nearness) + 1) % (1 << BITS);
        }
    }

    private static final class Counted extends Changed {
        private final AtomicInteger rows;

        Counted(DepthCoding.RangeCodes right, AtomicInteger rows) {
            super(right);
            this.rows = rows;
        }

        @Override
        public void row(double base, double perPixel, int from, int to, int[] codes) {
            super.row(base, perPixel, from, to, codes);
            for (int i = from; i < to; i++) codes[i - from] += rows.get();
            rows.incrementAndGet();
        }
    }

    private static final class LinearZ extends Changed {
        LinearZ(DepthCoding.RangeCodes right) {
            super(right);
        }

        @Override
        public void row(double base, double perPixel, int from, int to, int[] codes) {
            double first = 1 / (base + from * perPixel);
            double last = 1 / (base + (to - 1) * perPixel);
            for (int i = from; i < to; i++) {
                double share = to - from == 1 ? 0 : (double) (i - from) / (to - 1 - from);
                codes[i - from] = code(1 / (first + share * (last - first)));
            }
        }
    }
}
