package rasterlab.engine.pipeline.fast;

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

    /** Boxes with so many pixels or less have them listed one by one, row by row. */
    private static final int FEW = TinyScan.FEW;

    /** What is listed beside pixels 0 to {@link TinyScan#FEW} − 1: a box with more of them. */
    static final int BOX = FEW;

    /** What is listed for a triangle that is not small. */
    static final int LARGE = FEW + 1;

    /** What {@link #code} is for these two. */
    static final int CODE_OF_BOX = 1 << FEW;

    static final int CODE_OF_LARGE = CODE_OF_BOX + 1;

    /** What is listed for a code, from FEW·code on, times SIZE; HOW_MANY of it counts. */
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

    /**
     * Which pixels of a box with few are owned, a bit for each; else {@link #CODE_OF_BOX} or {@link
     * #CODE_OF_LARGE}.
     */
    final int[] code = new int[SIZE];

    /** The cell of pixel k of a box with few pixels, at k·SIZE + i for triangle i. */
    final int[] cell = new int[FEW * SIZE];

    /** The weights of b and c, where the pixel is owned. */
    final float[] weightB = new float[FEW * SIZE];

    final float[] weightC = new float[FEW * SIZE];

    /** What there is to draw, {@code kind · SIZE + triangle}. */
    private final int[] listed = new int[SIZE * FEW];

    /** How many are listed. */
    int length;

    private int[] corners;
    private int first;

    /** A vertex that clipping made is kept as its complement ~v, which is v ^ −1. */
    private int complement;

    /**
     * Takes the next triangles until there is no room or one is of the other kind: of the mesh, or
     * made by clipping.
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

    /** Corner k, 0 to 2, in the mesh's order: a vertex of {@link #vertices}. */
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

    /** Whether a pixel is listed at a place, which may be the list's end. */
    boolean isPixel(int place) {
        return place < length && listed[place] < BOX * SIZE;
    }

    /** Where the listed pixel has its cell and weights. */
    int pixel(int place) {
        return listed[place];
    }

    /** The depth of the listed pixel. */
    float depth(int place) {
        int triangle = triangle(place);
        int pixel = pixel(place);
        float za = vertices.depth(a[triangle]);
        float zb = vertices.depth(b[triangle]) - za;
        float zc = vertices.depth(c[triangle]) - za;
        return za + weightB[pixel] * zb + weightC[pixel] * zc;
    }
}
