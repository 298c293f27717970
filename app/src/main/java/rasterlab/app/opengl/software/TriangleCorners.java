package rasterlab.app.opengl.software;

import java.util.Arrays;
import rasterlab.engine.scene.TriangleMesh;

/** Corners of triangles in eye space, three after three, each with its own colour and texture. */
final class TriangleCorners {
    /** x, y, z, red, green, blue, alpha, s, t. */
    static final int NUMBERS = 9;

    static final int RED = 3;
    static final int ALPHA = 6;

    private float[] numbers = new float[NUMBERS * 1024];
    private int count;

    /**
     * @param corner {@value #NUMBERS} numbers
     */
    void add(double[] corner) {
        if (NUMBERS * (count + 1) > numbers.length)
            numbers = Arrays.copyOf(numbers, 2 * numbers.length);
        for (int k = 0; k < NUMBERS; k++) numbers[NUMBERS * count + k] = (float) corner[k];
        count++;
    }

    boolean isEmpty() {
        return count == 0;
    }

    TriangleMesh mesh() {
        int[] triangles = new int[count];
        for (int i = 0; i < count; i++) triangles[i] = i;
        return TriangleMesh.of(column(0), column(1), column(2), triangles)
                .withTexture(column(7), column(8))
                .withColors(column(3), column(4), column(5), column(6));
    }

    private float[] column(int k) {
        float[] column = new float[count];
        for (int i = 0; i < count; i++) column[i] = numbers[NUMBERS * i + k];
        return column;
    }
}
