package rasterlab.engine.border;

import java.util.List;
import java.util.Random;

/** Numbers where arithmetic in doubles and ints changes its ways, and ordinary ones beside them. */
public final class BorderNumbers {
    private static final double[] DOUBLES = {
        0.0,
        Double.MIN_VALUE,
        Math.nextDown(Double.MIN_NORMAL),
        Double.MIN_NORMAL,
        Math.nextUp(Double.MIN_NORMAL),
        0x1p-538,
        Math.nextDown(1.0),
        1.0,
        Math.nextUp(1.0),
        0x1p53,
        Float.MIN_VALUE,
        Float.MAX_VALUE,
        0x1p511,
        0x1p512,
        0x1p1023,
        Double.MAX_VALUE,
    };

    private static final int[] INTS = {
        0, 1, 2, 3, 7, 46_340, 46_341, 65_535, 65_536, 1 << 24, 1 << 29, 1 << 30, Integer.MAX_VALUE
    };

    private BorderNumbers() {}

    /** One of the border numbers of doubles, of either sign; −0.0 is one. */
    public static double border(Random random) {
        double number = DOUBLES[random.nextInt(DOUBLES.length)];
        return random.nextBoolean() ? number : -number;
    }

    /** One of the border numbers of ints or the next one to it, of either sign. */
    public static long whole(Random random) {
        long number = INTS[random.nextInt(INTS.length)] + random.nextInt(3) - 1L;
        return random.nextBoolean() ? number : -number;
    }

    /** A number as a person writes it, or any of a usual size. */
    public static double ordinary(Random random) {
        return switch (random.nextInt(4)) {
            case 0 -> random.nextInt(17) - 8;
            case 1 -> (random.nextInt(161) - 80) / 8.0;
            case 2 -> (random.nextInt(201) - 100) / 10.0;
            default -> random.nextDouble(-100, 100);
        };
    }

    /** A random number of any sign, mantissa and exponent. */
    public static double anywhere(Random random) {
        int exponent = random.nextInt(Double.MIN_EXPONENT - 52, Double.MAX_EXPONENT + 1);
        double number = Math.scalb(random.nextDouble(1, 2), exponent);
        return random.nextBoolean() ? number : -number;
    }

    /** A number related to ones that stand elsewhere in the same input. */
    public static double related(Random random, List<Double> earlier) {
        double a = earlier.get(random.nextInt(earlier.size()));
        double b = earlier.get(random.nextInt(earlier.size()));
        return switch (random.nextInt(9)) {
            case 0, 1 -> a;
            case 2 -> Math.nextUp(a);
            case 3 -> Math.nextDown(a);
            case 4 -> -a;
            case 5 -> a / 2 + b / 2;
            case 6 -> a + b;
            case 7 -> a - b;
            default -> 2 * a - b;
        };
    }
}
