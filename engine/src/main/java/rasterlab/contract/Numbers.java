package rasterlab.contract;

/** The checks of the numbers in this package's records. */
final class Numbers {
    private Numbers() {}

    /** A copy of three finite numbers. */
    static double[] vector(String name, double[] xyz) {
        requireThree(name, xyz);
        for (double value : xyz)
            if (!Double.isFinite(value))
                throw new IllegalArgumentException(
                        "%s must be finite, got (%s, %s, %s)"
                                .formatted(name, xyz[0], xyz[1], xyz[2]));
        return xyz.clone();
    }

    /** A copy of shares of red, green and blue, each from 0 to {@code highest}. */
    static double[] shares(String name, double[] rgb, double highest) {
        requireThree(name, rgb);
        for (double share : rgb)
            if (!(share >= 0 && share <= highest))
                throw new IllegalArgumentException(
                        "%s must have shares from 0 to %s, got (%s, %s, %s)"
                                .formatted(name, (int) highest, rgb[0], rgb[1], rgb[2]));
        return rgb.clone();
    }

    private static void requireThree(String name, double[] values) {
        if (values.length != 3)
            throw new IllegalArgumentException(name + " must have 3 numbers, got " + values.length);
    }
}
