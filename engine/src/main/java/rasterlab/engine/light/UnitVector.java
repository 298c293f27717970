package rasterlab.engine.light;

/** Vectors brought to length 1. */
public final class UnitVector {
    private UnitVector() {}

    /**
     * Divides x, y, z by their length, whatever its size: the largest of them is taken out first,
     * so that no square overflows or vanishes.
     *
     * @param vector finite
     * @return false for (0, 0, 0), which stays so
     */
    public static boolean normalize(double[] vector) {
        double largest =
                Math.max(Math.abs(vector[0]), Math.max(Math.abs(vector[1]), Math.abs(vector[2])));
        if (largest == 0) return false;
        double x = vector[0] / largest;
        double y = vector[1] / largest;
        double z = vector[2] / largest;
        double length = Math.sqrt(x * x + y * y + z * z);
        vector[0] = x / length;
        vector[1] = y / length;
        vector[2] = z / length;
        return true;
    }

    /** The length of x, y, z, whatever its size. */
    public static double length(double[] vector) {
        double largest =
                Math.max(Math.abs(vector[0]), Math.max(Math.abs(vector[1]), Math.abs(vector[2])));
        if (largest == 0) return 0;
        double x = vector[0] / largest;
        double y = vector[1] / largest;
        double z = vector[2] / largest;
        return largest * Math.sqrt(x * x + y * y + z * z);
    }
}
