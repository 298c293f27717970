package rasterlab.engine.pipeline.surface;

import rasterlab.engine.texture.TextureSampler;

/**
 * Two filters as OpenGL has them: one where texels are smaller than pixels, one where they are
 * larger.
 *
 * <p>Source: M. Segal, K. Akeley, The OpenGL Graphics System: A Specification, version 2.1, 2006,
 * sections 3.8.8 and 3.8.9.
 *
 * @param smooth whether larger texels are mixed
 */
public record MinMag(MinificationFilter smaller, boolean smooth) {
    /** How texels are looked up that are smaller than pixels. */
    public enum MinificationFilter {
        NEAREST {
            @Override
            int texel(TextureSampler sampler, double s, double t, double lambda) {
                return sampler.nearest(s, t);
            }
        },
        LINEAR {
            @Override
            int texel(TextureSampler sampler, double s, double t, double lambda) {
                return sampler.linear(s, t);
            }
        },
        NEAREST_MIPMAP_NEAREST {
            @Override
            int texel(TextureSampler sampler, double s, double t, double lambda) {
                return sampler.nearestLevel(s, t, lambda);
            }
        },
        LINEAR_MIPMAP_NEAREST {
            @Override
            int texel(TextureSampler sampler, double s, double t, double lambda) {
                return sampler.linearLevel(s, t, lambda);
            }
        },
        NEAREST_MIPMAP_LINEAR {
            @Override
            int texel(TextureSampler sampler, double s, double t, double lambda) {
                return sampler.nearestBetween(s, t, lambda);
            }
        },
        LINEAR_MIPMAP_LINEAR {
            @Override
            int texel(TextureSampler sampler, double s, double t, double lambda) {
                return sampler.trilinear(s, t, lambda);
            }
        };

        abstract int texel(TextureSampler sampler, double s, double t, double lambda);

        boolean nearestTexel() {
            return this == NEAREST_MIPMAP_NEAREST || this == NEAREST_MIPMAP_LINEAR;
        }
    }

    /** The λ up to which texels count as larger than pixels. */
    double limit() {
        return smooth && smaller.nearestTexel() ? 0.5 : 0;
    }

    /**
     * @param lambda the level of detail, as {@link rasterlab.engine.texture.DetailLevel} has it
     */
    int texel(TextureSampler sampler, double s, double t, double lambda) {
        if (lambda > limit()) return smaller.texel(sampler, s, t, lambda);
        return smooth ? sampler.linear(s, t) : sampler.nearest(s, t);
    }
}
