// Bends fibres (papers/002, section 4; FINDINGS 9): eight side by side in each work-item. The twin of fibres_numba.py,
// operation for operation: whoever changes one changes both. Contraction is off: a fused multiply-add rounds otherwise.
#pragma OPENCL FP_CONTRACT OFF

#define LANES 8
#define ROW 24
#define CARRIED 1
#define GROUNDED 2
#define LEAST_PUSH 1e-30f
#define LEAST_STIFFNESS 1e-12f
#define FASTEST 1e4f
#define STRONGEST 1e12f
#define SHARPEST 1e9f
#define ANTIPODE 1e-3f
#define LOST 1e-6f

typedef struct { float8 x, y, z; } vec;

static vec load3(global const float *from) {
    return (vec){vload8(0, from), vload8(1, from), vload8(2, from)};
}

static void store3(vec v, global float *to) {
    vstore8(v.x, 0, to);
    vstore8(v.y, 1, to);
    vstore8(v.z, 2, to);
}

static float8 dot3(vec a, vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

static vec scaled(vec a, float8 s) { return (vec){a.x * s, a.y * s, a.z * s}; }

static vec added(vec a, vec b) { return (vec){a.x + b.x, a.y + b.y, a.z + b.z}; }

static vec less(vec a, vec b) { return (vec){a.x - b.x, a.y - b.y, a.z - b.z}; }

// In each lane b where the mask is set, else a.
static vec chosen(vec a, vec b, int8 mask) {
    return (vec){select(a.x, b.x, mask), select(a.y, b.y, mask), select(a.z, b.z, mask)};
}

static vec bounded(vec a, float most) {
    const float8 high = most, low = -most;
    return (vec){min(max(a.x, low), high), min(max(a.y, low), high), min(max(a.z, low), high)};
}

// The sine of an angle in turns.
static float8 wave(float8 turns) {
    const float8 s = turns - floor(turns + 0.5f);
    float8 size = fabs(s);
    size = min(size, 0.5f - size) * 6.2831855f;
    const float8 q = size * size;
    float8 p = (float)(-1.0 / 39916800.0) * q + (float)(1.0 / 362880.0);
    p = p * q + (float)(-1.0 / 5040.0);
    p = p * q + (float)(1.0 / 120.0);
    p = p * q + (float)(-1.0 / 6.0);
    const float8 value = size + size * q * p;
    return select(-value, value, s >= 0.0f);
}

// Adds to the flow [m/s] and the holes' gain [1/s] at p: eqs. 2-5 over a list of singularities.
static void flow_at(global const float *packed, global const int *member, int begin, int end, vec p, vec *flow,
                    float8 *gain) {
    vec f = *flow;
    float8 g = *gain;
    for (int at = begin; at < end; at++) {
        global const float *k = packed + 16 * member[at];
        const vec q = {p.x - k[0], p.y - k[1], p.z - k[2]};
        const float8 d2 = dot3(q, q);
        float8 inside = 2.0f - d2 * k[14];
        if (!any(inside > 0.0f)) continue;
        inside = min(max(inside, 0.0f), 1.0f);
        float8 push = k[8] * (inside * inside * (3.0f - 2.0f * inside));
        if (k[7] < 1.5f) {
            push = push / ((k[9] + d2) * sqrt(d2 + k[10]) + LEAST_PUSH);
            f = added(f, scaled(q, push));
            g = g + max(-push, 0.0f);
        } else if (k[7] < 2.5f) {
            const vec c = {q.y * k[6] - q.z * k[5], q.z * k[4] - q.x * k[6], q.x * k[5] - q.y * k[4]};
            push = push / ((k[9] + d2) * sqrt(dot3(c, c) + k[10]) + LEAST_PUSH);
            f = added(f, scaled(c, push));
        } else {
            const float8 turns = k[12] * (p.x * k[4] + p.y * k[5] + p.z * k[6]) + k[13];
            push = push * (1.0f + k[11] * wave(turns));
            f = (vec){f.x + push * k[4], f.y + push * k[5], f.z + push * k[6]};
        }
    }
    *flow = f;
    *gain = g;
}

// The distance [m] to a rock, negative inside, and the way out.
static float8 rock_at(global const float *k, vec p, vec *out) {
    const vec d = {p.x - k[0], p.y - k[1], p.z - k[2]};
    const float cosine = k[8], sine = k[9];
    vec u = {(cosine * d.x + sine * d.y) * k[4], (cosine * d.y - sine * d.x) * k[5], d.z * k[6]};
    const float8 k0 = sqrt(dot3(u, u));
    u = (vec){u.x * k[4], u.y * k[5], u.z * k[6]};
    const float8 k1 = sqrt(dot3(u, u));
    const int8 clear = k1 > LOST;
    const vec n = {(cosine * u.x - sine * u.y) / k1, (sine * u.x + cosine * u.y) / k1, u.z / k1};
    const vec up = {0.0f, 0.0f, 1.0f};
    *out = chosen(up, n, clear);
    return select((float8)(-k[3]), k0 * (k0 - 1.0f) / k1, clear);
}

// Points [m] moved out of the rocks and the ground that hold them, one after the other.
static vec outside(global const float *rocks, global const int *member, int begin, int end, global const float *plane,
                   vec p) {
    for (int near = begin; near < end; near++) {
        vec n;
        const float8 away = min(rock_at(rocks + 12 * member[near], p, &n), 0.0f);
        p = less(p, scaled(n, away));
    }
    const vec n = load3(plane);
    const float8 away = min(dot3(n, p) - vload8(3, plane), 0.0f);
    return less(p, scaled(n, away));
}

// Sets the root of a carried fibre as its carrier's node has moved and turned: the least turn between directions.
static void turn_root(global const float *perch, global const float *rest, global float *root, int node,
                      global float *position, global float *direction, int first, int lane) {
    const int above = ROW * (node / LANES) + node % LANES;
    const float3 e = {perch[24 + lane], perch[32 + lane], perch[40 + lane]};
    const float3 d = {direction[above], direction[above + 8], direction[above + 16]};
    const float c = e.x * d.x + e.y * d.y + e.z * d.z;
    const float3 w = {e.y * d.z - e.z * d.y, e.z * d.x - e.x * d.z, e.x * d.y - e.y * d.x};
    const float share = 1.0f / max(1.0f + c, ANTIPODE);
    const int own = ROW * first + lane;
    for (int part = 0; part < 3; part++) {
        global const float *from = (part == 0 ? perch : rest + 24 * (part - 1)) + lane;
        const float x = from[0], y = from[8], z = from[16];
        const float along = (w.x * x + w.y * y + w.z * z) * share;
        const float px = c * x + (w.y * z - w.z * y) + w.x * along;
        const float py = c * y + (w.z * x - w.x * z) + w.y * along;
        const float pz = c * z + (w.x * y - w.y * x) + w.z * along;
        if (part == 0) {
            position[own] = position[above] + px;
            position[own + 8] = position[above + 8] + py;
            position[own + 16] = position[above + 16] + pz;
        } else {
            global float *to = root + 24 * (part - 1) + lane;
            to[0] = px, to[8] = py, to[16] = pz;
        }
        if (part == 1) {
            direction[own] = px, direction[own + 8] = py, direction[own + 16] = pz;
        }
    }
}

kernel void bend(int begin, int end, float part_of_way, global const int *order, global const int *bundles,
                 global const float *rest, global const float *length, global const float *area,
                 global const float *stiffness, global const float *rest_root, global float *root,
                 global const float *perch, global const int *carrier, global const float *plane,
                 global float *direction, global float *position, global const float *packed,
                 global const int *list_first,
                 global const int *list_member, global const float *rocks, global const int *rock_first,
                 global const int *rock_member) {
    const int turn = begin + get_global_id(0);
    if (turn >= end) return;
    const int bundle = order[turn];
    const int first = bundles[4 * bundle], nodes = bundles[4 * bundle + 1], clump = bundles[4 * bundle + 2];
    const int list_begin = list_first[clump], list_end = list_first[clump + 1];
    const int rock_begin = rock_first[clump], rock_end = rock_first[clump + 1];
    plane += 32 * bundle;
    root += 48 * bundle;
    if (bundles[4 * bundle + 3] & CARRIED)
        for (int lane = 0; lane < LANES; lane++)
            turn_root(perch + 48 * bundle, rest_root + 48 * bundle, root, carrier[LANES * bundle + lane], position,
                      direction, first, lane);

    // Force and moment, from tip to root; the net force takes the place of the position.
    vec carry = {0.0f, 0.0f, 0.0f};
    float8 m0 = 0.0f, m1 = 0.0f, gain = 0.0f, below = 0.0f;
    for (int at = first + 1; at < first + nodes; at++) below = below + vload8(at, length);
    for (int at = first + nodes - 1; at > first; at--) {
        const vec p = load3(position + ROW * at);
        vec flow = {0.0f, 0.0f, 0.0f};
        float8 holes = 0.0f;
        flow_at(packed, list_member, list_begin, list_end, p, &flow, &holes);
        for (int near = rock_begin; near < rock_end; near++) {
            vec n;
            const float8 away = rock_at(rocks + 12 * rock_member[near], p, &n);
            float8 push = min(1.0f - away * INVERSE_SKIN, 2.0f);
            const int8 felt = push > 0.0f;
            push = push * PUSH;
            flow = chosen(flow, added(flow, scaled(n, push)), felt);
            holes = select(holes, holes + PUSH_GAIN, felt);
        }
        holes = min(holes, SHARPEST);
        const float8 A = vload8(at, area), L = vload8(at, length);
        const vec force = bounded(added(scaled(bounded(flow, FASTEST), A), carry), STRONGEST);
        store3(force, position + ROW * at);
        m0 = m0 + A * holes;
        m1 = m1 + A * holes * below;
        below = below - L;
        const float8 arm = max(m1 - below * m0, 0.0f);
        gain = gain + arm / (vload8(at, stiffness) + LEAST_STIFFNESS);
        const vec d = load3(direction + ROW * at);
        const vec lengthwise = scaled(d, dot3(force, d));
        const vec across = less(force, lengthwise);
        if (at > first + 1) {
            const vec b = load3(direction + ROW * (at - 1));
            const vec g = less(scaled(across, dot3(b, d)), scaled(d, dot3(b, across)));
            const float8 size = sqrt(dot3(across, across)) * (L / vload8(at - 1, length));
            carry = added(lengthwise, scaled(scaled(g, 1.0f / sqrt(dot3(g, g) + LEAST_PUSH)), size));
        }
    }

    // Nothing is in the way of most fibres.
    const int attempts = rock_begin < rock_end || bundles[4 * bundle + 3] & GROUNDED ? 3 : 0;
    // Target directions, from root to tip; each segment eases towards its own.
    const float8 part = min((float8)(part_of_way), 1.0f / (1.0f + gain));
    vec t = load3(root), n = load3(root + ROW), x = load3(position + ROW * first);
    for (int at = first + 1; at < first + nodes; at++) {
        const vec r = load3(rest + ROW * at);
        const vec side = {t.y * n.z - t.z * n.y, t.z * n.x - t.x * n.z, t.x * n.y - t.y * n.x};
        const vec c = added(added(scaled(t, r.x), scaled(n, r.y)), scaled(side, r.z));
        const vec force = load3(position + ROW * at);
        const float8 along = dot3(force, c);
        const float8 hold = vload8(at, stiffness) + LEAST_STIFFNESS + max(along, 0.0f);
        vec s = added(less(force, scaled(c, along)), scaled(c, hold));
        float8 q = dot3(s, s);
        s = chosen(c, scaled(s, 1.0f / sqrt(q)), q > LEAST_PUSH);
        const float8 whole = max(1.0f + dot3(t, s), ANTIPODE);
        n = less(n, scaled(added(t, s), dot3(n, s) / whole));
        t = s;
        vec d = load3(direction + ROW * at);
        d = added(d, scaled(less(t, d), part));
        q = dot3(d, d);
        d = chosen(t, scaled(d, 1.0f / sqrt(q)), q > LOST);
        const float8 L = vload8(at, length);
        vec p = added(x, scaled(d, L));
        for (int again = 0; again < attempts; again++) {
            const vec out = outside(rocks, rock_member, rock_begin, rock_end, plane, p);
            int8 moved = out.x != p.x || out.y != p.y || out.z != p.z;
            const vec away = less(out, x);
            q = dot3(away, away);
            moved = moved && q > LEAST_PUSH;
            if (!any(moved)) break;
            d = chosen(d, scaled(away, 1.0f / sqrt(q)), moved);
            p = chosen(p, added(x, scaled(d, L)), moved);
        }
        store3(d, direction + ROW * at);
        store3(p, position + ROW * at);
        x = p;
    }
}
