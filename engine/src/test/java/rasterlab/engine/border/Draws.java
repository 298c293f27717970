package rasterlab.engine.border;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;

/**
 * The numbers that one input is made of, in the order in which they are asked for.
 *
 * <p>They are drawn at random and written down, or played back from such a list. An input can
 * therefore be made again with a number changed, which is how a {@link Shrinking} works without
 * knowing what the numbers mean.
 */
final class Draws {
    private final Random random;
    private final List<Double> played;
    private final List<Double> drawn = new ArrayList<>();
    private final int wildness;

    private Draws(Random random, List<Double> played) {
        this.random = random;
        this.played = played;
        // Of ten numbers so many lie at a border: an input of such numbers alone is often refused.
        wildness = random == null ? 0 : new int[] {0, 1, 3, 8}[random.nextInt(4)];
    }

    /** Numbers of that seed. */
    static Draws random(long seed) {
        var random = new Random(seed);
        // The first numbers of seeds that lie side by side are alike.
        random.nextLong();
        return new Draws(random, List.of());
    }

    /** These numbers; where more are asked for, zeros or what is nearest to them. */
    static Draws of(List<Double> numbers) {
        return new Draws(null, numbers);
    }

    /** All numbers so far. */
    List<Double> drawn() {
        return List.copyOf(drawn);
    }

    /** A finite number, each of them possible. */
    double number() {
        return number(-Double.MAX_VALUE, Double.MAX_VALUE);
    }

    /** Numbers, each of any kind. */
    double[] numbers(int count) {
        var numbers = new double[count];
        for (int i = 0; i < count; i++) numbers[i] = number();
        return numbers;
    }

    /** A number from least to most, both included. */
    double number(double least, double most) {
        return written(within(random == null ? next() : fresh(least, most), least, most));
    }

    private double fresh(double least, double most) {
        if (!drawn.isEmpty() && random.nextInt(4) == 0) return BorderNumbers.related(random, drawn);
        if (random.nextInt(10) < wildness)
            return switch (random.nextInt(4)) {
                case 0 -> random.nextBoolean() ? least : most;
                case 1 -> BorderNumbers.anywhere(random);
                default -> BorderNumbers.border(random);
            };
        return BorderNumbers.ordinary(random);
    }

    /** A whole number from least to most, both included. */
    int whole(int least, int most) {
        double number = random == null ? next() : freshWhole(least, most);
        return (int) written(within(Math.rint(number), least, most));
    }

    private double freshWhole(int least, int most) {
        if (!drawn.isEmpty() && random.nextInt(4) == 0) return BorderNumbers.related(random, drawn);
        if (random.nextInt(10) < wildness)
            return random.nextInt(3) == 0
                    ? random.nextBoolean() ? least : most
                    : BorderNumbers.whole(random);
        return random.nextInt(65) - 32;
    }

    /** One of so many, each as likely as the others. */
    int pick(int count) {
        double number = random == null ? next() : random.nextInt(count);
        return (int) written(within(Math.rint(number), 0, count - 1));
    }

    /** Both a number and its opposite are as likely. */
    boolean coin() {
        return pick(2) == 1;
    }

    private double next() {
        return drawn.size() < played.size() ? played.get(drawn.size()) : 0;
    }

    private static double within(double number, double least, double most) {
        // Where a sum of two has no double, any number serves.
        if (Double.isNaN(number)) return least;
        if (number == 0 && least < 0) return number;
        return Math.max(least, Math.min(most, number));
    }

    private double written(double number) {
        drawn.add(number);
        return number;
    }
}
