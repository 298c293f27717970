package rasterlab.engine.pipeline.triangle;

/**
 * Some successive triangles of a band, of which {@link RowLoops#find} finds the small ones many at
 * a time: of each what {@link TinyScan} knows of one, and where its box has few pixels, which of
 * them it owns.
 *
 * <p>What there is to draw is listed in the triangles' order: pixels of boxes with few, boxes with
 * more, triangles that are not small. No branch decides between them, since nobody could foresee
 * it. One per thread.
 */
final class TinyBlock {
    private static final int SIZE_BITS = 6;

    /** The most triangles. */
    static final int SIZE = 1 << SIZE_BITS;

    /** The most pixels of a box that are listed one by one, row by row. */
    static final int FEW = 4;

    /** What is listed beside pixels 0 to {@link #FEW} − 1 of a box: a box with more of them. */
    static final int BOX = FEW;

    /** And a triangle that is not small. */
    static final int LARGE = FEW + 1;

    /** What {@link #code} is for these two. */
    static final int CODE_OF_BOX = 1 << FEW;

    static final int CODE_OF_LARGE = CODE_OF_BOX + 1;

    /** For each code what is listed, and how much of it counts. */
    private static final int[] KINDS = new int[(CODE_OF_LARGE + 1) * FEW];

    private static final int[] HOW_MANY = new int[CODE_OF_LARGE + 1];

    static {
        for (int code = 0; code < CODE_OF_BOX; code++)
            for (int k = 0; k < FEW; k++) if ((code >> k & 1) != 0) addKind(code, k);
        addKind(CODE_OF_BOX, BOX);
        addKind(CODE_OF_LARGE, LARGE);
    }

    private static void addKind(int code, int kind) {
        KINDS[FEW * code + HOW_MANY[code]++] = kind * SIZE;
    }

    /** How many triangles there are. */
    int count;

    /** Where their corners are. */
    ScreenVertices vertices;

    /** The corners' numbers; once found, b and c are so turned that the area is positive. */
    final int[] a = new int[SIZE];

    final int[] b = new int[SIZE];
    final int[] c = new int[SIZE];

    /** The corners' places, in steps; once found, those of b and c seen from a. */
    final int[] ax = new int[SIZE];

    final int[] ay = new int[SIZE];
    final int[] bx = new int[SIZE];
    final int[] by = new int[SIZE];
    final int[] cx = new int[SIZE];
    final int[] cy = new int[SIZE];

    /** −1 where the triangle turns its inner side to the eye, else 0. */
    final int[] fromBehind = new int[SIZE];

    final float[] inverseArea = new float[SIZE];

    /** The box: its first column and row, its sides in pixels, the cell of its first pixel. */
    final int[] left = new int[SIZE];

    final int[] top = new int[SIZE];
    final int[] columns = new int[SIZE];
    final int[] rows = new int[SIZE];
    final int[] at = new int[SIZE];

    /** The edge functions, see {@link TinyScan}. */
    final int[] rowA = new int[SIZE];

    final int[] rowB = new int[SIZE];
    final int[] rowC = new int[SIZE];
    final int[] stepA = new int[SIZE];
    final int[] stepB = new int[SIZE];
    final int[] stepC = new int[SIZE];
    final int[] downA = new int[SIZE];
    final int[] downB = new int[SIZE];
    final int[] downC = new int[SIZE];
    final int[] ownB = new int[SIZE];
    final int[] ownC = new int[SIZE];

    /** Which pixels of a box with few are owned, a bit for each; or one of the two above. */
    final int[] code = new int[SIZE];

    /** Of a box with few pixels, at k·SIZE + i for triangle i: the cell of pixel k. */
    final int[] cell = new int[FEW * SIZE];

    /** And the weights of b and c, where the pixel is owned. */
    final float[] weightB = new float[FEW * SIZE];

    final float[] weightC = new float[FEW * SIZE];

    /** What there is to draw, {@code kind · SIZE + triangle}. */
    private final int[] listed = new int[(SIZE + 1) * FEW];

    /** How many are listed. */
    int length;

    private int[] corners;
    private int first;
    private int complement;

    /**
     * Takes triangles of the mesh or such that clipping made, as many as there is room for.
     *
     * @param from the first one's number in the chunk
     * @param end the number after the last that there is
     */
    void take(TriangleChunk chunk, int from, int end, ScreenVertices ofMesh) {
        corners = chunk.corners;
        first = from;
        boolean made = corners[3 * from] < 0;
        complement = made ? -1 : 0;
        vertices = made ? chunk.clipped : ofMesh;
        int most = Math.min(SIZE, end - from);
        for (count = 0; count < most; count++) {
            if (corners[3 * (from + count)] < 0 != made) return;
            a[count] = corner(count, 0);
            b[count] = corner(count, 1);
            c[count] = corner(count, 2);
            put(count, vertices.places[a[count]], ax, ay);
            put(count, vertices.places[b[count]], bx, by);
            put(count, vertices.places[c[count]], cx, cy);
        }
    }

    private static void put(int triangle, long place, int[] x, int[] y) {
        x[triangle] = (int) place;
        y[triangle] = (int) (place >> Integer.SIZE);
    }

    /** The vertex that is corner k of a triangle in the mesh, 0 to 2. */
    int corner(int triangle, int k) {
        return corners[3 * (first + triangle) + k] ^ complement;
    }

    /** Lists what there is to draw. */
    void list() {
        int n = 0;
        for (int i = 0; i < count; i++) {
            int kinds = FEW * code[i];
            for (int k = 0; k < FEW; k++) listed[n + k] = KINDS[kinds + k] + i;
            n += HOW_MANY[code[i]];
        }
        length = n;
    }

    /** What is listed at a place: the number of a pixel, {@link #BOX} or {@link #LARGE}. */
    int kind(int place) {
        return listed[place] >> SIZE_BITS;
    }

    /** Whose it is. */
    int triangle(int place) {
        return listed[place] & SIZE - 1;
    }

    /** Where the listed pixel has its cell and weights. */
    int pixel(int place) {
        return listed[place];
    }
}
