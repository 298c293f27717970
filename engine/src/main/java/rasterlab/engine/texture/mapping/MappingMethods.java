package rasterlab.engine.texture.mapping;

import java.util.List;
import rasterlab.contract.TextureMapper;
import rasterlab.contract.TexturedSpan;
import rasterlab.engine.study.Method;

/** The methods of the topic, in teaching order. */
final class MappingMethods {

    private MappingMethods() {}

    static List<Method<TextureMapper>> all() {
        return List.of(
                Method.failing("affine", new AffineMapper(TexturedSpan.MOST_PIXELS)),
                Method.failing("affine-16", new AffineMapper(16)),
                Method.failing("stepped-float", new SteppedMapper()),
                Method.right("perspective", new PerspectiveMapper()),
                Method.failing("affine-textbook", new AffineTextbookMapper()));
    }
}
