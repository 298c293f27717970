package rasterlab.contract;

/**
 * A triangle with a lamp and an eye, all in one space without a perspective division.
 *
 * @param corners x, y, z of three corners, counter-clockwise seen from the side to shade
 * @param normals x, y, z of the normal at each corner, of any length
 * @param lamp x, y, z of the light's place
 * @param eye x, y, z of the eye
 * @param globalAmbient light from everywhere that no source sends, shares 0 to 1000
 */
public record LitFace(
        double[] corners,
        double[] normals,
        double[] lamp,
        double[] eye,
        SurfaceMaterial material,
        LightSource light,
        double[] globalAmbient) {
    /** The largest magnitude of a coordinate. */
    public static final double LARGEST = 1e75;

    public LitFace {
        corners = nine("corners", corners);
        normals = nine("normals", normals);
        lamp = within("lamp", Numbers.vector("lamp", lamp));
        eye = within("eye", Numbers.vector("eye", eye));
        globalAmbient = Numbers.shares("global-ambient", globalAmbient, LightSource.BRIGHTEST);
    }

    private static double[] nine(String name, double[] numbers) {
        if (numbers.length != 9)
            throw new IllegalArgumentException(
                    name + " must have 9 numbers, got " + numbers.length);
        for (int i = 0; i < 9; i++)
            if (!isWithin(numbers[i]))
                throw beyond("%s[%d].%s".formatted(name, i / 3, "xyz".charAt(i % 3)), numbers[i]);
        return numbers.clone();
    }

    private static double[] within(String name, double[] numbers) {
        for (int i = 0; i < numbers.length; i++)
            if (!isWithin(numbers[i])) throw beyond(name + "[" + i + "]", numbers[i]);
        return numbers;
    }

    private static boolean isWithin(double number) {
        return Math.abs(number) <= LARGEST;
    }

    private static IllegalArgumentException beyond(String place, double number) {
        return new IllegalArgumentException(
                "%s must be from -1E75 to 1E75, got %s".formatted(place, number));
    }
}
