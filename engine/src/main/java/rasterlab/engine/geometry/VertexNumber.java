package rasterlab.engine.geometry;

/** Tells which numbers of vertices there are. */
public final class VertexNumber {
    private VertexNumber() {}

    public static boolean exists(int number, int vertices) {
        return number >= 0 && number < vertices;
    }

    /**
     * The refusal of a number that no vertex has.
     *
     * @param place where it stands, in words that begin the sentence; may be empty
     */
    public static String refusal(String place, int number, int vertices) {
        String known =
                vertices == 0
                        ? "must be a vertex, of which there are none"
                        : "must be a vertex from 0 to " + (vertices - 1);
        return (place + " " + known + ", got " + number).strip();
    }
}
