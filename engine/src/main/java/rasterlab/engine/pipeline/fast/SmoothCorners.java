package rasterlab.engine.pipeline.fast;

/**
 * Depth, 1/w and colours of a triangle's corners: a's, and what b and c have more. One per thread.
 */
final class SmoothCorners {
    float inverseArea;
    float za;
    float zb;
    float zc;
    float qa;
    float qb;
    float qc;
    float ra;
    float rb;
    float rc;
    float ga;
    float gb;
    float gc;
    float ba;
    float bb;
    float bc;

    /** 1/w of b and c themselves. */
    float ofB;

    float ofC;

    void load(Scan scan, ScreenVertices v) {
        int a = scan.a;
        int b = scan.b;
        int c = scan.c;
        inverseArea = scan.inverseArea;
        za = v.depth(a);
        zb = v.depth(b) - za;
        zc = v.depth(c) - za;
        ofB = v.nearness(b);
        ofC = v.nearness(c);
        qa = v.nearness(a);
        qb = ofB - qa;
        qc = ofC - qa;
        float[] rgb = v.values;
        int atA = v.at(a);
        int atB = v.at(b);
        int atC = v.at(c);
        ra = rgb[atA];
        rb = rgb[atB] - ra;
        rc = rgb[atC] - ra;
        ga = rgb[atA + 1];
        gb = rgb[atB + 1] - ga;
        gc = rgb[atC + 1] - ga;
        ba = rgb[atA + 2];
        bb = rgb[atB + 2] - ba;
        bc = rgb[atC + 2] - ba;
    }
}
