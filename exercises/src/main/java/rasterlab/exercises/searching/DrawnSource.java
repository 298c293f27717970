package rasterlab.exercises.searching;

import java.io.IOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import rasterlab.engine.border.BorderNumbers;
import rasterlab.engine.format.Field;
import rasterlab.engine.format.Given;
import rasterlab.engine.format.InvalidInput;
import rasterlab.engine.format.Shape;
import rasterlab.engine.format.ValueSource;

/**
 * Draws each value that is asked for, so that a topic's description of its input makes one.
 *
 * <p>An input has one temper: small whole numbers, among which many are equal, or ordinary ones, or
 * those at the borders of arithmetic. Numbers and points are often related to earlier ones: equal,
 * an ulp apart, half way, on one line.
 */
final class DrawnSource implements ValueSource {
    private static final String CHARACTERS = "..##*ab";
    private static final int SMALL = 10;
    private static final int MOST_ITEMS = 9;

    /** Numbers of a point that has steps or directions beside its place: some may all be 0. */
    private static final int SEVERAL = 4;

    /** Whole numbers of which any may be drawn, such as levels of grey. */
    private static final int FEW_WHOLE = 1000;

    private final Random random;
    private final int temper;
    private final List<Double> numbers = new ArrayList<>();

    /** How many items the last list of that name has: the rows of a table are alike. */
    private final Map<String, Integer> lengths = new HashMap<>();

    /**
     * @param calm whether numbers of a usual size are wanted
     */
    DrawnSource(Random random, boolean calm) {
        this.random = random;
        temper = random.nextInt(calm ? 2 : 4);
    }

    @Override
    public boolean startsObject() {
        return random.nextBoolean();
    }

    @Override
    public boolean startsArray() {
        return random.nextBoolean();
    }

    @Override
    public boolean isNull() {
        return random.nextInt(4) == 0;
    }

    @Override
    public Given object(List<Field<?>> fields) throws IOException {
        var given = new Given();
        for (Field<?> field : fields)
            if (field.required() || random.nextBoolean()) given.put(field, drawn(field.shape()));
        return given;
    }

    private Object drawn(Shape<?> shape) throws IOException {
        return shape.read(this);
    }

    @Override
    public Given openObject(List<Field<?>> fields) throws IOException {
        return object(fields);
    }

    private int count(int least, int most) {
        int room = Math.min(most - least, MOST_ITEMS);
        return least + random.nextInt(1 + room);
    }

    @Override
    public <T> List<T> list(String what, Shape<T> item, int least, int most) throws IOException {
        var items = new ArrayList<T>();
        int length = length(what, least, most);
        for (int left = length; left > 0; left--)
            items.add(
                    !items.isEmpty() && random.nextInt(8) == 0
                            ? items.get(random.nextInt(items.size()))
                            : item.read(this));
        lengths.put(what, length);
        return items;
    }

    private int length(String what, int least, int most) {
        int last = lengths.getOrDefault(what, most + 1);
        boolean alike = last >= least && last <= most && random.nextInt(4) > 0;
        return alike ? last : count(least, most);
    }

    /** Draws numbers of which some may be 0, as in a direction that lies along an axis. */
    @Override
    public double[] numbers(int least, int most) {
        var drawn = new double[count(least, most)];
        boolean along = random.nextInt(4) == 0;
        for (int i = 0; i < drawn.length; i++)
            drawn[i] = along && random.nextBoolean() ? 0 : number();
        return drawn;
    }

    @Override
    public double[] points(int dimension, int least, int most) {
        var drawn = new double[dimension * count(least, most)];
        boolean[] zero = new boolean[dimension];
        if (dimension >= SEVERAL && random.nextBoolean())
            for (int axis = 0; axis < dimension; axis++) zero[axis] = random.nextBoolean();
        for (int i = 0; i < drawn.length; i += dimension) {
            point(drawn, i, dimension);
            for (int axis = 0; axis < dimension; axis++) if (zero[axis]) drawn[i + axis] = 0;
        }
        return drawn;
    }

    /** Draws a point by itself, or equal to an earlier one, or on the line through two. */
    private void point(double[] drawn, int at, int dimension) {
        int kind = at == 0 ? 2 : random.nextInt(10);
        int one = at == 0 ? 0 : dimension * random.nextInt(at / dimension);
        int other = at == 0 ? 0 : dimension * random.nextInt(at / dimension);
        double along = new double[] {0.5, 2, -1, 0.25, 1.0 / 3}[random.nextInt(5)];
        for (int axis = 0; axis < dimension; axis++) {
            double a = drawn[one + axis];
            double b = drawn[other + axis];
            double number =
                    switch (kind) {
                        case 0 -> a;
                        case 1 -> a + along * (b - a);
                        default -> number();
                    };
            drawn[at + axis] = Double.isFinite(number) ? number : a;
        }
    }

    @Override
    public int[] wholes(int count) {
        var drawn = new int[count];
        for (int i = 0; i < count; i++) drawn[i] = whole(Integer.MIN_VALUE, Integer.MAX_VALUE);
        return drawn;
    }

    @Override
    public double number() {
        return numberFrom(-Double.MAX_VALUE, Double.MAX_VALUE);
    }

    @Override
    public double numberFrom(double least, double most) {
        double number = fresh();
        if (!Double.isFinite(number)) number = 0;
        if (number < least || number > most) number = inside(least, most);
        numbers.add(number);
        return number;
    }

    private double inside(double least, double most) {
        return switch (random.nextInt(4)) {
            case 0 -> least;
            case 1 -> most;
            default -> least + random.nextDouble() * Math.min(most - least, Double.MAX_VALUE);
        };
    }

    private double fresh() {
        if (!numbers.isEmpty() && random.nextInt(5) == 0)
            return BorderNumbers.related(random, numbers);
        if (random.nextInt(12) == 0) return RoundNumbers.any(random);
        return switch (temper) {
            case 0 -> random.nextInt(SMALL);
            case 1 -> BorderNumbers.ordinary(random);
            case 2 ->
                    random.nextInt(5) == 0
                            ? BorderNumbers.border(random)
                            : BorderNumbers.ordinary(random);
            default ->
                    random.nextBoolean()
                            ? BorderNumbers.border(random)
                            : BorderNumbers.anywhere(random);
        };
    }

    @Override
    public double numberAbove(double least, double most) {
        return Math.max(Math.nextUp(least), numberFrom(least, most));
    }

    @Override
    public int whole(int least, int most) {
        boolean few = most > least && (long) most - least < FEW_WHOLE;
        if (few && random.nextBoolean()) return least + random.nextInt(most - least + 1);
        long number =
                switch (temper) {
                    case 0, 1 -> random.nextInt(SMALL);
                    case 2 -> random.nextInt(65) - 32;
                    default -> BorderNumbers.whole(random);
                };
        if (number < least || number > most)
            number = least + (long) (random.nextDouble() * Math.min(40, (long) most - least));
        numbers.add((double) number);
        return (int) number;
    }

    @Override
    public boolean flag() {
        return random.nextBoolean();
    }

    @Override
    public String word(List<String> allowed) {
        return allowed.get(random.nextInt(allowed.size()));
    }

    @Override
    public String text(String expected, int least, int most) {
        var text = new StringBuilder();
        for (int left = count(least, most); left > 0; left--)
            text.append(CHARACTERS.charAt(random.nextInt(CHARACTERS.length())));
        return text.toString();
    }

    @Override
    public InvalidInput invalid(String reason) {
        return new InvalidInput(reason);
    }
}
