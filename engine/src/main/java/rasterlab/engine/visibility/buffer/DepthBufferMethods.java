package rasterlab.engine.visibility.buffer;

import java.util.List;
import rasterlab.engine.study.Method;
import rasterlab.engine.visibility.Visibility;

/** Depth buffers by what they store. */
public final class DepthBufferMethods {

    private DepthBufferMethods() {}

    public static List<Method<Visibility>> all() {
        return List.of(
                fixed(16, 16),
                fixed(24, 8),
                fixed(32, 16),
                Method.failing("zfloat", new ZBuffer(range -> new NearnessCodes())),
                Method.failing("reversed-z", new ZBuffer(ReversedCodes::new)));
    }

    private static Method<Visibility> fixed(int bits, int fraction) {
        return Method.failing(
                "z" + bits, new ZBuffer(range -> new FixedCodes(bits, fraction, range)));
    }
}
