package rasterlab.exercises.drawing;

import java.util.Random;

/** Draws numbers of one sort for a while: all alike, neighbours, huge, tiny, any bits at all. */
final class AnyNumbers {
    private final Random random;
    private final int sort;
    private final double base;

    AnyNumbers(Random random) {
        this.random = random;
        sort = random.nextInt(7);
        base = random.nextGaussian() * Math.pow(10, random.nextInt(600) - 300);
    }

    double next() {
        return switch (random.nextInt(12) == 0 ? 6 : sort) {
            case 0 -> base;
            case 1 -> base + random.nextInt(4) * Math.ulp(base);
            case 2 -> (random.nextDouble() * 2 - 1) * Double.MAX_VALUE;
            case 3 -> random.nextInt(4) * Double.MIN_VALUE;
            case 4 -> random.nextGaussian() * 100;
            case 5 -> random.nextBoolean() ? 1e308 * random.nextInt(2) : random.nextInt(3);
            default -> Double.longBitsToDouble(random.nextLong());
        };
    }

    double[] some(int count) {
        var numbers = new double[count];
        for (int i = 0; i < count; i++) numbers[i] = next();
        return numbers;
    }
}
