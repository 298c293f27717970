package rasterlab.engine.texture.mapping;

import java.util.Map;
import rasterlab.contract.TextureMapper;
import rasterlab.contract.TexturedSpan;

/** A mapper that says what it has to do. */
interface CountedMapper extends TextureMapper {
    /** The method's operations on numbers along a row: divisions, multiplications, additions. */
    Map<String, Long> operations(TexturedSpan span);

    /** Operations under their names. */
    static Map<String, Long> counts(long divisions, long multiplications, long additions) {
        return Map.of(
                "divisions", divisions,
                "multiplications", multiplications,
                "additions", additions);
    }
}
