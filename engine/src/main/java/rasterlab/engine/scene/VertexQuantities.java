package rasterlab.engine.scene;

import java.util.EnumMap;
import java.util.Locale;
import java.util.Map;

/** The numbers of all vertices of a mesh, one array for each quantity, checked once. */
final class VertexQuantities {
    private static final double UNIT_TOLERANCE = 1e-3;

    private final Map<VertexQuantity, float[]> values;

    private VertexQuantities(Map<VertexQuantity, float[]> values) {
        this.values = values;
    }

    static VertexQuantities positions(float[] x, float[] y, float[] z) {
        var none = new VertexQuantities(new EnumMap<>(VertexQuantity.class));
        return none.with(VertexQuantity.X, x, y, z);
    }

    VertexQuantities withNormals(float[] nx, float[] ny, float[] nz) {
        VertexQuantities with = with(VertexQuantity.NORMAL_X, nx, ny, nz);
        for (int v = 0; v < count(); v++) {
            double length = Math.sqrt((double) nx[v] * nx[v] + ny[v] * ny[v] + nz[v] * nz[v]);
            if (!(Math.abs(length - 1) <= UNIT_TOLERANCE))
                throw new IllegalArgumentException(
                        "vertex %d: the normal must have length 1, got (%s, %s, %s)"
                                .formatted(v, nx[v], ny[v], nz[v]));
        }
        return with;
    }

    VertexQuantities withTexture(float[] s, float[] t) {
        return with(VertexQuantity.TEXTURE_S, s, t);
    }

    VertexQuantities withColors(float[]... channels) {
        VertexQuantities with = with(VertexQuantity.RED, channels);
        for (float[] channel : channels)
            for (int v = 0; v < channel.length; v++)
                if (!(channel[v] >= 0 && channel[v] <= 1))
                    throw new IllegalArgumentException(
                            "vertex %d: a colour must be from 0 to 1, got %s"
                                    .formatted(v, channel[v]));
        return with;
    }

    /** The arrays are for the quantity first and those declared after it. */
    private VertexQuantities with(VertexQuantity first, float[]... arrays) {
        var more = new EnumMap<VertexQuantity, float[]>(VertexQuantity.class);
        more.putAll(values);
        for (int k = 0; k < arrays.length; k++) {
            VertexQuantity quantity = VertexQuantity.values()[first.ordinal() + k];
            check(quantity, arrays[k], values.isEmpty() ? arrays[0].length : count());
            more.put(quantity, arrays[k].clone());
        }
        return new VertexQuantities(more);
    }

    private static void check(VertexQuantity quantity, float[] array, int count) {
        if (array.length != count)
            throw new IllegalArgumentException(
                    "%s needs one number for each of %d vertices, got %d"
                            .formatted(name(quantity), count, array.length));
        for (int v = 0; v < count; v++)
            if (!Float.isFinite(array[v]))
                throw new IllegalArgumentException(
                        "vertex %d: %s must be finite, got %s"
                                .formatted(v, name(quantity), array[v]));
    }

    private static String name(VertexQuantity quantity) {
        return quantity.name().toLowerCase(Locale.ROOT).replace('_', ' ');
    }

    int count() {
        return values.get(VertexQuantity.X).length;
    }

    boolean has(VertexQuantity quantity) {
        return values.containsKey(quantity);
    }

    float[] values(VertexQuantity quantity) {
        float[] array = values.get(quantity);
        if (array == null)
            throw new IllegalArgumentException(
                    "the mesh has no " + name(quantity) + " of vertices");
        return array;
    }
}
