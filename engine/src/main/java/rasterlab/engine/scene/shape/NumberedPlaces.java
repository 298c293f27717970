package rasterlab.engine.scene.shape;

import java.util.Arrays;

/** Different places in space, numbered from 0 in the order in which they came. */
final class NumberedPlaces {
    private double[] xyz = new double[3 * 256];

    /** The number of a place + 1 where its hash points, or at the next free entry; 0 where free. */
    private int[] table = new int[1024];

    private int count;

    /**
     * The number of a place, a new one if its coordinates are not those of a known one; −0 is 0.
     */
    int number(double x, double y, double z) {
        double px = x + 0.0;
        double py = y + 0.0;
        double pz = z + 0.0;
        int entry = entry(px, py, pz);
        if (table[entry] > 0) return table[entry] - 1;
        if (3 * count == xyz.length) xyz = Arrays.copyOf(xyz, 2 * xyz.length);
        xyz[3 * count] = px;
        xyz[3 * count + 1] = py;
        xyz[3 * count + 2] = pz;
        table[entry] = ++count;
        if (2 * count > table.length) grow();
        return count - 1;
    }

    /** The places' x, y and z, one after another. */
    double[] coordinates() {
        return Arrays.copyOf(xyz, 3 * count);
    }

    private int entry(double x, double y, double z) {
        long bits = Double.doubleToLongBits(x);
        bits = 31 * mixed(bits) + Double.doubleToLongBits(y);
        bits = 31 * mixed(bits) + Double.doubleToLongBits(z);
        int entry = (int) mixed(bits) & table.length - 1;
        while (table[entry] > 0 && !is(table[entry] - 1, x, y, z))
            entry = entry + 1 & table.length - 1;
        return entry;
    }

    /** Every bit of a number changes about half of those of its hash (Stafford, 2011). */
    private static long mixed(long bits) {
        long once = (bits ^ bits >>> 30) * 0xBF58476D1CE4E5B9L;
        long twice = (once ^ once >>> 27) * 0x94D049BB133111EBL;
        return twice ^ twice >>> 31;
    }

    private boolean is(int place, double x, double y, double z) {
        return xyz[3 * place] == x && xyz[3 * place + 1] == y && xyz[3 * place + 2] == z;
    }

    private void grow() {
        table = new int[2 * table.length];
        for (int place = 0; place < count; place++)
            table[entry(xyz[3 * place], xyz[3 * place + 1], xyz[3 * place + 2])] = place + 1;
    }
}
