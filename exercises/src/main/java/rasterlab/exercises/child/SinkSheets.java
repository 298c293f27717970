package rasterlab.exercises.child;

import java.io.DataInputStream;
import java.io.IOException;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.util.List;
import java.util.stream.Stream;
import rasterlab.contract.CoveragePixels;
import rasterlab.contract.CurvePoints;
import rasterlab.contract.PieceSink;
import rasterlab.contract.PixelGrid;
import rasterlab.contract.Pixels;
import rasterlab.contract.PolygonSink;
import rasterlab.contract.SegmentSink;
import rasterlab.contract.SpaceSegmentSink;
import rasterlab.contract.Spans;

/** The sheets for all kinds of sinks, and for pictures. */
public final class SinkSheets {
    private static final List<Class<?>> KINDS =
            List.of(
                    Pixels.class,
                    CoveragePixels.class,
                    Spans.class,
                    CurvePoints.class,
                    SegmentSink.class,
                    SpaceSegmentSink.class,
                    PolygonSink.class,
                    PieceSink.class,
                    PixelGrid.class);

    private SinkSheets() {}

    /** The contracts' sinks and pictures, which the child has beside an exercise's own types. */
    public static List<Class<?>> kinds() {
        return KINDS;
    }

    static boolean isKept(Class<?> type) {
        return KINDS.contains(type);
    }

    /**
     * A fresh sheet.
     *
     * @param in where a picture is read from
     */
    static SinkSheet of(Class<?> kind, DataInputStream in, int most, int room) throws IOException {
        if (kind == PixelGrid.class) return GridSheet.read(in, most);
        if (kind == Pixels.class) return new WholeSheets.OfPixels(most, room);
        if (kind == CoveragePixels.class || kind == Spans.class)
            return new WholeSheets.OfThree(most, room);
        if (kind == PolygonSink.class || kind == PieceSink.class)
            return new PolygonSheet(kind == PieceSink.class, most);
        return new RealSheet(taking(kind).getParameterCount(), most, room);
    }

    /**
     * Sends what {@link SinkSheet#writeTo} wrote to a sink, or into a picture, of this process;
     * returns the number of items.
     */
    static int replay(Class<?> kind, DataInputStream in, Object into) throws IOException {
        int items = Values.length(in, Integer.BYTES);
        if (into instanceof Pixels pixels) {
            for (int left = items; left > 0; left--) pixels.plot(in.readInt(), in.readInt());
            return items;
        }
        Method taking = taking(kind);
        Class<?>[] types = taking.getParameterTypes();
        for (int left = items; left > 0; left--) {
            Object[] item = new Object[types.length];
            for (int i = 0; i < item.length; i++) item[i] = Values.read(types[i], in);
            send(taking, into, item);
        }
        return items;
    }

    private static void send(Method taking, Object into, Object[] item) throws IOException {
        try {
            taking.invoke(into, item);
        } catch (InvocationTargetException e) {
            if (e.getCause() instanceof RuntimeException refused) throw refused;
            throw new AssertionError("a sink throws no " + e.getCause(), e);
        } catch (IllegalAccessException e) {
            throw new AssertionError("a contract's methods are public", e);
        }
    }

    /** The method that takes items. */
    private static Method taking(Class<?> kind) {
        return Stream.of(kind.getMethods())
                .filter(one -> Modifier.isAbstract(one.getModifiers()))
                .filter(one -> one.getReturnType() == void.class)
                .findFirst()
                .orElseThrow();
    }
}
