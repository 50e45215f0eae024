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

// Plain operators where OpenCL has functions: PoCL leaves those calls where its library was built for another processor
// than it finds, and around a call every register is saved. That would be two fifths of the time.
static float8 square_root(float8 a) {
#if defined(__clang__) && defined(__x86_64__)
    // One vsqrtps, exact as sqrt is here.
    return (float8)(__builtin_sqrtf(a.s0), __builtin_sqrtf(a.s1), __builtin_sqrtf(a.s2), __builtin_sqrtf(a.s3),
                    __builtin_sqrtf(a.s4), __builtin_sqrtf(a.s5), __builtin_sqrtf(a.s6), __builtin_sqrtf(a.s7));
#else
    return sqrt(a);
#endif
}

static float8 least(float8 a, float8 b) { return b < a ? b : a; }

static float8 most(float8 a, float8 b) { return a < b ? b : a; }

static float8 magnitude(float8 a) { return as_float8(as_int8(a) & 0x7fffffff); }

static bool any_of(int8 mask) {
    const ulong4 pairs = as_ulong4(mask);
    return (pairs.x | pairs.y | pairs.z | pairs.w) != 0;
}

static vec load3(global const float8 *from) { return (vec){from[0], from[1], from[2]}; }

static void store3(vec v, global float8 *to) { to[0] = v.x, to[1] = v.y, to[2] = v.z; }

static float8 dot3(vec a, vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

static vec scaled(vec a, float8 s) { return (vec){a.x * s, a.y * s, a.z * s}; }

static vec added(vec a, vec b) { return (vec){a.x + b.x, a.y + b.y, a.z + b.z}; }

static vec less(vec a, vec b) { return (vec){a.x - b.x, a.y - b.y, a.z - b.z}; }

// In each lane b where the mask is set, else a.
static vec chosen(vec a, vec b, int8 mask) {
    return (vec){mask ? b.x : a.x, mask ? b.y : a.y, mask ? b.z : a.z};
}

static vec bounded(vec a, float far) {
    const float8 high = far, low = -far;
    return (vec){least(most(a.x, low), high), least(most(a.y, low), high), least(most(a.z, low), high)};
}

// The sine of an angle in turns.
static float8 wave(float8 turns) {
    const float8 s = turns - floor(turns + 0.5f);
    float8 size = magnitude(s);
    size = least(size, 0.5f - size) * 6.2831855f;
    const float8 q = size * size;
    float8 p = (float)(-1.0 / 39916800.0) * q + (float)(1.0 / 362880.0);
    p = p * q + (float)(-1.0 / 5040.0);
    p = p * q + (float)(1.0 / 120.0);
    p = p * q + (float)(-1.0 / 6.0);
    const float8 value = size + size * q * p;
    return s >= 0.0f ? value : -value;
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
        if (!any_of(inside > 0.0f)) continue;
        inside = least(most(inside, 0.0f), 1.0f);
        float8 push = k[8] * (inside * inside * (3.0f - 2.0f * inside));
        if (k[7] < 1.5f) {
            push = push / ((k[9] + d2) * square_root(d2 + k[10]) + LEAST_PUSH);
            f = added(f, scaled(q, push));
            g = g + most(-push, 0.0f);
        } else if (k[7] < 2.5f) {
            const vec c = {q.y * k[6] - q.z * k[5], q.z * k[4] - q.x * k[6], q.x * k[5] - q.y * k[4]};
            push = push / ((k[9] + d2) * square_root(dot3(c, c) + k[10]) + LEAST_PUSH);
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
    const float8 k0 = square_root(dot3(u, u));
    u = (vec){u.x * k[4], u.y * k[5], u.z * k[6]};
    const float8 k1 = square_root(dot3(u, u));
    const int8 clear = k1 > LOST;
    const vec n = {(cosine * u.x - sine * u.y) / k1, (sine * u.x + cosine * u.y) / k1, u.z / k1};
    const vec up = {0.0f, 0.0f, 1.0f};
    *out = chosen(up, n, clear);
    return clear ? k0 * (k0 - 1.0f) / k1 : (float8)(-k[3]);
}

// Points [m] moved out of the rocks and the ground that hold them, one after the other.
static vec outside(global const float *rocks, global const int *member, int begin, int end, global const float8 *plane,
                   vec p) {
    for (int near = begin; near < end; near++) {
        vec n;
        const float8 away = least(rock_at(rocks + 12 * member[near], p, &n), 0.0f);
        p = less(p, scaled(n, away));
    }
    const vec n = load3(plane);
    const float8 away = least(dot3(n, p) - plane[3], 0.0f);
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
                 global const float8 *rest, global const float8 *length, global const float8 *area,
                 global const float8 *stiffness, global const float *rest_root, global float8 *root,
                 global const float *perch, global const int *carrier, global const float8 *plane,
                 global float8 *direction, global float8 *position, global const float *packed,
                 global const int *list_first,
                 global const int *list_member, global const float *rocks, global const int *rock_first,
                 global const int *rock_member) {
    const int turn = begin + get_global_id(0);
    if (turn >= end) return;
    const int bundle = order[turn];
    const int first = bundles[4 * bundle], nodes = bundles[4 * bundle + 1], clump = bundles[4 * bundle + 2];
    const int list_begin = list_first[clump], list_end = list_first[clump + 1];
    const int rock_begin = rock_first[clump], rock_end = rock_first[clump + 1];
    plane += 4 * bundle;
    root += 6 * bundle;
    if (bundles[4 * bundle + 3] & CARRIED)
        for (int lane = 0; lane < LANES; lane++)
            turn_root(perch + 48 * bundle, rest_root + 48 * bundle, (global float *)root, carrier[LANES * bundle + lane],
                      (global float *)position, (global float *)direction, first, lane);

    // Force and moment, from tip to root; the net force takes the place of the position.
    vec carry = {0.0f, 0.0f, 0.0f};
    float8 m0 = 0.0f, m1 = 0.0f, gain = 0.0f, below = 0.0f;
    for (int at = first + 1; at < first + nodes; at++) below = below + length[at];
    for (int at = first + nodes - 1; at > first; at--) {
        const vec p = load3(position + 3 * at);
        vec flow = {0.0f, 0.0f, 0.0f};
        float8 holes = 0.0f;
        flow_at(packed, list_member, list_begin, list_end, p, &flow, &holes);
        for (int near = rock_begin; near < rock_end; near++) {
            vec n;
            const float8 away = rock_at(rocks + 12 * rock_member[near], p, &n);
            float8 push = least(1.0f - away * INVERSE_SKIN, 2.0f);
            const int8 felt = push > 0.0f;
            push = push * PUSH;
            flow = chosen(flow, added(flow, scaled(n, push)), felt);
            holes = felt ? holes + PUSH_GAIN : holes;
        }
        holes = least(holes, SHARPEST);
        const float8 A = area[at], L = length[at];
        const vec force = bounded(added(scaled(bounded(flow, FASTEST), A), carry), STRONGEST);
        store3(force, position + 3 * at);
        m0 = m0 + A * holes;
        m1 = m1 + A * holes * below;
        below = below - L;
        const float8 arm = most(m1 - below * m0, 0.0f);
        gain = gain + arm / (stiffness[at] + LEAST_STIFFNESS);
        const vec d = load3(direction + 3 * at);
        const vec lengthwise = scaled(d, dot3(force, d));
        const vec across = less(force, lengthwise);
        if (at > first + 1) {
            const vec b = load3(direction + 3 * (at - 1));
            const vec g = less(scaled(across, dot3(b, d)), scaled(d, dot3(b, across)));
            const float8 size = square_root(dot3(across, across)) * (L / length[at - 1]);
            carry = added(lengthwise, scaled(scaled(g, 1.0f / square_root(dot3(g, g) + LEAST_PUSH)), size));
        }
    }

    // Nothing is in the way of most fibres.
    const int attempts = rock_begin < rock_end || bundles[4 * bundle + 3] & GROUNDED ? 3 : 0;
    // Target directions, from root to tip; each segment eases towards its own.
    const float8 part = least((float8)(part_of_way), 1.0f / (1.0f + gain));
    vec t = load3(root), n = load3(root + 3), x = load3(position + 3 * first);
    for (int at = first + 1; at < first + nodes; at++) {
        const vec r = load3(rest + 3 * at);
        const vec side = {t.y * n.z - t.z * n.y, t.z * n.x - t.x * n.z, t.x * n.y - t.y * n.x};
        const vec c = added(added(scaled(t, r.x), scaled(n, r.y)), scaled(side, r.z));
        const vec force = load3(position + 3 * at);
        const float8 along = dot3(force, c);
        const float8 hold = stiffness[at] + LEAST_STIFFNESS + most(along, 0.0f);
        vec s = added(less(force, scaled(c, along)), scaled(c, hold));
        float8 q = dot3(s, s);
        s = chosen(c, scaled(s, 1.0f / square_root(q)), q > LEAST_PUSH);
        const float8 whole = most(1.0f + dot3(t, s), ANTIPODE);
        n = less(n, scaled(added(t, s), dot3(n, s) / whole));
        t = s;
        vec d = load3(direction + 3 * at);
        d = added(d, scaled(less(t, d), part));
        q = dot3(d, d);
        d = chosen(t, scaled(d, 1.0f / square_root(q)), q > LOST);
        const float8 L = length[at];
        vec p = added(x, scaled(d, L));
        for (int again = 0; again < attempts; again++) {
            const vec out = outside(rocks, rock_member, rock_begin, rock_end, plane, p);
            int8 moved = out.x != p.x || out.y != p.y || out.z != p.z;
            const vec away = less(out, x);
            q = dot3(away, away);
            moved = moved && q > LEAST_PUSH;
            if (!any_of(moved)) break;
            d = chosen(d, scaled(away, 1.0f / square_root(q)), moved);
            p = chosen(p, added(x, scaled(d, L)), moved);
        }
        store3(d, direction + 3 * at);
        store3(p, position + 3 * at);
        x = p;
    }
}
