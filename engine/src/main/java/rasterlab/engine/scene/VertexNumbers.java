package rasterlab.engine.scene;

import java.util.Arrays;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import rasterlab.engine.format.Field;
import rasterlab.engine.format.InvalidInput;
import rasterlab.engine.format.MadeShape;
import rasterlab.engine.format.Shape;
import rasterlab.engine.geometry.VertexNumber;

/** The corners of a face from outside: at least 3 numbers of vertices. */
public final class VertexNumbers extends MadeShape<List<Integer>, int[]> {
    /** The field {@code faces}. */
    public static final Field<List<int[]>> FACES =
            Field.required("faces", Shape.list("faces", new VertexNumbers(), 0, Shape.MOST_POINTS));

    private static final int MOST = 1_000_000;

    /**
     * Passes if each corner is one of the vertices.
     *
     * @throws InvalidInput with the place of the first that is none
     */
    public static void require(int[][] faces, int vertices) {
        for (int f = 0; f < faces.length; f++)
            for (int k = 0; k < faces[f].length; k++)
                if (!VertexNumber.exists(faces[f][k], vertices))
                    throw new InvalidInput(
                            "/faces/" + f + "/" + k,
                            VertexNumber.refusal("", faces[f][k], vertices));
    }

    /** A refusal of a {@link Mesh} with the place of its face. */
    public static InvalidInput invalid(IllegalArgumentException refusal) {
        Matcher ofFace = Refusal.OF_FACE.matcher(refusal.getMessage());
        return ofFace.matches()
                ? new InvalidInput("/faces/" + ofFace.group(1), ofFace.group(2))
                : new InvalidInput("/", refusal.getMessage());
    }

    /** A refusal, which is made only where something is refused. */
    private static final class Refusal {
        static final Pattern OF_FACE = Pattern.compile("face (\\d+): (.*)", Pattern.DOTALL);
    }

    private VertexNumbers() {
        super(Shape.described(from(Integer.MIN_VALUE), from(0)));
    }

    private static Shape<List<Integer>> from(int least) {
        return Shape.list("vertex numbers", Shape.whole(least, Integer.MAX_VALUE), 3, MOST);
    }

    @Override
    protected int[] made(List<Integer> numbers) {
        return numbers.stream().mapToInt(Integer::intValue).toArray();
    }

    @Override
    protected List<Integer> value(int[] numbers) {
        return Arrays.stream(numbers).boxed().toList();
    }
}
