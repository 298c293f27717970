package rasterlab.engine.pipeline.fast;

import java.util.Arrays;
import rasterlab.engine.scene.TriangleMesh;
import rasterlab.engine.scene.VertexQuantity;

/**
 * Vertices a block at a time: all of them world → clip → pixels; then what the surface wants, world
 * → eye and their colours, of those that triangles in sight have.
 *
 * <p>The loops over whole arrays are as plain as they are so that the compiler turns them into
 * vector instructions. One per thread.
 */
final class VertexStage {
    private final VertexBlock block = new VertexBlock();

    /** World positions or normals of the block's vertices, whichever are transformed. */
    private final float[] worldX = new float[VertexBlock.SIZE];

    private final float[] worldY = new float[VertexBlock.SIZE];
    private final float[] worldZ = new float[VertexBlock.SIZE];
    private final float[] clipX = new float[VertexBlock.SIZE];
    private final float[] clipY = new float[VertexBlock.SIZE];
    private final float[] clipZ = new float[VertexBlock.SIZE];
    private final float[] clipW = new float[VertexBlock.SIZE];

    static int blocks(TriangleMesh mesh) {
        return (mesh.vertexCount() + VertexBlock.SIZE - 1) / VertexBlock.SIZE;
    }

    /** Row point times column {@code column} of a matrix: the same operations in every caller. */
    static float dot(float[] matrix, int column, float x, float y, float z) {
        return x * matrix[column]
                + y * matrix[4 + column]
                + z * matrix[8 + column]
                + matrix[12 + column];
    }

    /** Finds the places of a block of vertices on the picture. */
    void place(FrameState frame, int index) {
        int from = index * VertexBlock.SIZE;
        block.count = Math.min(VertexBlock.SIZE, frame.mesh.vertexCount() - from);
        project(frame, from);
    }

    /** Finds the attributes of those groups of a block's vertices that are needed. */
    void fill(FrameState frame, int index) {
        int end = Math.min((index + 1) * VertexBlock.SIZE, frame.mesh.vertexCount());
        int from = index * VertexBlock.SIZE;
        while (from < end) {
            int to = from;
            while (to < end && frame.vertices.needed[to / ScreenVertices.GROUP])
                to += ScreenVertices.GROUP;
            if (to > from) fill(frame, from, Math.min(to, end));
            from = to + ScreenVertices.GROUP;
        }
    }

    private void fill(FrameState frame, int from, int end) {
        block.count = end - from;
        block.first = from;
        take(frame.mesh, VertexQuantity.X, from);
        putDepths(frame, from);
        if (frame.needsEye()) toEye(frame, from);
        putPlaces(frame, from);
        if (frame.hasColors()) color(frame, from);
    }

    private void project(FrameState frame, int from) {
        take(frame.mesh, VertexQuantity.X, from);
        float[] matrix = frame.view.toClip();
        transform(matrix, 0, clipX);
        transform(matrix, 1, clipY);
        transform(matrix, 2, clipZ);
        transform(matrix, 3, clipW);
        ScreenVertices out = frame.vertices;
        place(block.count, clipX, clipY, clipW, frame.subpixels, out.places, from);
        int any = findCodes(out.code, from);
        double[][] planes = frame.view.worldPlanes();
        if (planes.length > 0)
            for (int i = 0; i < block.count; i++) {
                int user = ClipCode.ofUser(planes, worldX[i], worldY[i], worldZ[i]);
                any |= out.code[from + i] |= (short) user;
            }
        if (any != 0) frame.anyBeyond = true;
        if (ClipCode.mustClip(any)) frame.clips = true;
    }

    /**
     * Copies three quantities of the block's vertices to where {@link #transform} finds them.
     *
     * @param first of the three
     * @param from the block's first vertex
     */
    private void take(TriangleMesh mesh, VertexQuantity first, int from) {
        int k = first.ordinal();
        System.arraycopy(mesh.values(FrameState.QUANTITIES[k]), from, worldX, 0, block.count);
        System.arraycopy(mesh.values(FrameState.QUANTITIES[k + 1]), from, worldY, 0, block.count);
        System.arraycopy(mesh.values(FrameState.QUANTITIES[k + 2]), from, worldZ, 0, block.count);
    }

    /** All arrays have one index: of others the compiler would make no vector instructions. */
    private void transform(float[] matrix, int column, float[] out) {
        float perX = matrix[column];
        float perY = matrix[4 + column];
        float perZ = matrix[8 + column];
        float shift = matrix[12 + column];
        for (int i = 0; i < block.count; i++)
            out[i] = worldX[i] * perX + worldY[i] * perY + worldZ[i] * perZ + shift;
    }

    /** Returns what some vertex has of a {@link ClipCode}. */
    private int findCodes(short[] codes, int from) {
        if (allSeen(block.count, clipX, clipY, clipZ, clipW)) {
            Arrays.fill(codes, from, from + block.count, (short) 0);
            return 0;
        }
        int any = 0;
        for (int i = 0; i < block.count; i++) {
            int code = ClipCode.of(clipX[i], clipY[i], clipZ[i], clipW[i]);
            any |= code;
            codes[from + i] = (short) code;
        }
        return any;
    }

    /** Computes the depths again, so that nothing is written for vertices out of sight. */
    private void putDepths(FrameState frame, int from) {
        transform(frame.view.toClip(), 2, clipZ);
        transform(frame.view.toClip(), 3, clipW);
        depths(block.count, clipZ, clipW);
        for (int i = 0; i < block.count; i++) frame.vertices.put(from + i, clipZ[i], clipW[i]);
    }

    private void toEye(FrameState frame, int from) {
        TriangleMesh mesh = frame.mesh;
        float[] matrix = frame.view.toEye();
        transform(matrix, 0, block.x);
        transform(matrix, 1, block.y);
        transform(matrix, 2, block.z);
        if (!mesh.hasNormals()) {
            Arrays.fill(block.nx, 0);
            Arrays.fill(block.ny, 0);
            Arrays.fill(block.nz, 0);
            return;
        }
        take(mesh, VertexQuantity.NORMAL_X, from);
        float[] turn = frame.view.normalToEye();
        transform(turn, 0, block.nx);
        transform(turn, 1, block.ny);
        transform(turn, 2, block.nz);
    }

    /** Writes the quantities besides colours, of which the colours are made. */
    private void putPlaces(FrameState frame, int from) {
        for (int k = 0; k < frame.attributeCount; k++) {
            VertexQuantity quantity = frame.attribute[k];
            if (FrameState.isColor(quantity)) return;
            ScreenVertices to = frame.vertices;
            switch (quantity) {
                case X -> put(to, k, block.x, 0, from);
                case Y -> put(to, k, block.y, 0, from);
                case Z -> put(to, k, block.z, 0, from);
                case NORMAL_X -> put(to, k, block.nx, 0, from);
                case NORMAL_Y -> put(to, k, block.ny, 0, from);
                case NORMAL_Z -> put(to, k, block.nz, 0, from);
                default -> put(to, k, frame.mesh.values(quantity), from, from);
            }
        }
    }

    /**
     * Writes attribute k of the block's vertices.
     *
     * @param first where their values begin
     * @param from the block's first vertex
     */
    private void put(ScreenVertices to, int k, float[] values, int first, int from) {
        float[] written = to.values;
        int stride = to.stride;
        int at = to.at(from) + k;
        for (int i = 0; i < block.count; i++) written[at + stride * i] = values[first + i];
    }

    private void color(FrameState frame, int from) {
        channel(frame.mesh, VertexQuantity.RED, from, block.red);
        channel(frame.mesh, VertexQuantity.GREEN, from, block.green);
        channel(frame.mesh, VertexQuantity.BLUE, from, block.blue);
        channel(frame.mesh, VertexQuantity.ALPHA, from, block.alpha);
        frame.vertexColors().colors().color(block);
        float most = frame.surface instanceof Surface.PerPixel ? 1 : 255;
        for (int k = 0; k < frame.attributeCount; k++)
            switch (frame.attribute[k]) {
                case RED -> putShares(frame.vertices, k, block.red, most, from);
                case GREEN -> putShares(frame.vertices, k, block.green, most, from);
                case BLUE -> putShares(frame.vertices, k, block.blue, most, from);
                case ALPHA -> putShares(frame.vertices, k, block.alpha, most, from);
                default -> {}
            }
    }

    private void channel(TriangleMesh mesh, VertexQuantity quantity, int from, float[] out) {
        if (mesh.hasColors()) System.arraycopy(mesh.values(quantity), from, out, 0, block.count);
        else Arrays.fill(out, 0, block.count, 1);
    }

    /**
     * Writes a channel of the block's vertices, cut to its range.
     *
     * @param most what the share 1 becomes
     */
    private void putShares(ScreenVertices to, int k, float[] channel, float most, int from) {
        for (int i = 0; i < block.count; i++)
            channel[i] = most * Math.max(0, Math.min(1, channel[i]));
        put(to, k, channel, 0, from);
    }

    /** Whether all of n vertices in clip space have the {@link ClipCode} 0. */
    static boolean allSeen(int n, float[] x, float[] y, float[] z, float[] w) {
        for (int i = 0; i < n; i++) if (ClipCode.of(x[i], y[i], z[i], w[i]) != 0) return false;
        return true;
    }

    /**
     * Finds the {@linkplain ScreenVertices#places places} of n vertices in clip space; one that w
     * gives none, or that is beyond the guard, has any.
     *
     * @param places the first vertex's is {@code places[from]}
     */
    private static void place(
            int n, float[] x, float[] y, float[] w, Subpixels subpixels, long[] places, int from) {
        for (int i = 0; i < n; i++) {
            double nearness = 1.0 / w[i];
            int pixelX = subpixels.x(x[i] * nearness);
            places[from + i] = ScreenVertices.place(pixelX, subpixels.y(y[i] * nearness));
        }
    }

    /** Replaces z of n vertices by their depth, 0 to 1 if they are seen, w by 1/w. */
    private static void depths(int n, float[] z, float[] w) {
        for (int i = 0; i < n; i++) {
            double nearness = 1.0 / w[i];
            z[i] = (float) (0.5 + 0.5 * (z[i] * nearness));
            w[i] = (float) nearness;
        }
    }
}
