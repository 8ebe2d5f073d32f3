import './tracing.ts';
